// A device that is lost, or has no memory left, in the middle of a picture. The calls that fail are put in the place of
// the loader's: volk keeps every Vulkan function in a variable, so nothing in the library has to know of this test.

#include "support/device.hpp"
#include "support/pictures.hpp"

#include "gpu/vulkan.hpp"

#include <velarium/error.hpp>

#include <gtest/gtest.h>

#include <string>

namespace velarium::test {
namespace {

// Replaces one function of Vulkan for its own lifetime.
template <class Function>
class Replaced {
 public:
  Replaced(Function& place, Function by) : place_(place), original_(place) { place_ = by; }
  ~Replaced() { place_ = original_; }
  Replaced(const Replaced&) = delete;
  Replaced& operator=(const Replaced&) = delete;

 private:
  Function& place_;
  Function original_;
};

VKAPI_ATTR VkResult VKAPI_CALL lose_device(VkQueue, std::uint32_t, const VkSubmitInfo2*, VkFence) {
  return VK_ERROR_DEVICE_LOST;
}

VKAPI_ATTR VkResult VKAPI_CALL lose_device_while_waiting(VkDevice device, std::uint32_t, const VkFence*, VkBool32,
                                                         std::uint64_t) {
  vkDeviceWaitIdle(device);  // the work is really under way: nothing of it may be freed before it ends
  return VK_ERROR_DEVICE_LOST;
}

template <VkResult kResult>
VKAPI_ATTR VkResult VKAPI_CALL refuse_memory(VkDevice, const VkMemoryAllocateInfo*, const VkAllocationCallbacks*,
                                             VkDeviceMemory*) {
  return kResult;
}

RenderRequest small() {
  RenderRequest request = linear_request(16, 16);
  request.environment = "white";
  return request;
}

// More than the blocks that an engine keeps can hold, so that it asks for memory.
RenderRequest large() {
  RenderRequest request = linear_request(2048, 2048);
  request.environment = "white";
  return request;
}

// Rendering must end in the error that asks to try again, in words that say why.
void expect_temporary(Engine& engine, const RenderRequest& request, const std::string& says) {
  try {
    (void)engine.picture(Scene::load("builtin:spheres"), request);
    ADD_FAILURE() << "a picture, although the device failed";
  } catch (const Error& error) {
    EXPECT_EQ(static_cast<int>(error.code()), 75) << error.what();
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
  }
}

TEST(DeviceFailures, ALostDeviceAsksToTryAgain) {
  Engine engine(validated());
  const Replaced lost(vkQueueSubmit2, PFN_vkQueueSubmit2(lose_device));
  expect_temporary(engine, small(), "device was lost");
}

TEST(DeviceFailures, ADeviceLostAtWorkAsksToTryAgain) {
  Engine engine(validated());
  const Replaced lost(vkWaitForFences, PFN_vkWaitForFences(lose_device_while_waiting));
  expect_temporary(engine, small(), "device was lost");
}

TEST(DeviceFailures, RefusedMemoryAsksToTryAgain) {
  for (const auto refuse : {PFN_vkAllocateMemory(refuse_memory<VK_ERROR_OUT_OF_DEVICE_MEMORY>),
                            PFN_vkAllocateMemory(refuse_memory<VK_ERROR_OUT_OF_HOST_MEMORY>)}) {
    Engine engine(validated());
    const Replaced full(vkAllocateMemory, refuse);
    expect_temporary(engine, large(), "out of memory");
  }
}

TEST(DeviceFailures, AnEngineOutlivesRefusedMemory) {
  Engine engine(validated());
  {
    const Replaced full(vkAllocateMemory, PFN_vkAllocateMemory(refuse_memory<VK_ERROR_OUT_OF_DEVICE_MEMORY>));
    expect_temporary(engine, large(), "out of memory");
  }
  EXPECT_EQ(engine.picture(Scene::load("builtin:spheres"), small()).linear.size(), std::size_t{4} * 16 * 16);
}

}  // namespace
}  // namespace velarium::test
