// The tests of pictures count on the validation layers: broken rules must end as errors.

#include "support/device.hpp"

#include "gpu/buffer.hpp"
#include "gpu/device.hpp"

#include <velarium/error.hpp>

#include <gtest/gtest.h>

namespace velarium::test {
namespace {

ErrorCode code_of_submitting(gpu::Device& device, VkCommandBuffer commands) {
  try {
    device.submit_and_wait(commands);
  } catch (const Error& error) { return error.code(); }
  return ErrorCode::usage;
}

TEST(Validation, ABrokenRuleIsAnError) {
  gpu::Device device(device_choice(), true);
  const VkCommandBuffer commands = device.begin();
  vkCmdSetLineWidth(commands, 2.0f);  // the device has not enabled wideLines
  EXPECT_EQ(code_of_submitting(device, commands), ErrorCode::internal);
}

TEST(Validation, AMissingBarrierIsAnError) {
  gpu::Device device(device_choice(), true);
  const gpu::Buffer buffer(device, 64, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryUse::device);
  const VkCommandBuffer commands = device.begin();
  vkCmdFillBuffer(commands, buffer.vk(), 0, 64, 1u);
  vkCmdFillBuffer(commands, buffer.vk(), 0, 64, 2u);
  EXPECT_EQ(code_of_submitting(device, commands), ErrorCode::internal);
}

TEST(Validation, KeptRulesAreNoError) {
  gpu::Device device(device_choice(), true);
  const gpu::Buffer buffer(device, 64, VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::MemoryUse::device);
  const VkCommandBuffer commands = device.begin();
  vkCmdFillBuffer(commands, buffer.vk(), 0, 64, 1u);
  EXPECT_NO_THROW(device.submit_and_wait(commands));
}

}  // namespace
}  // namespace velarium::test
