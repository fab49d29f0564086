// The table of accesses, on which every barrier rests.

#include "graph/access.hpp"

#include <gtest/gtest.h>

#include <array>

namespace velarium::graph {
namespace {

constexpr std::array kReadOnly{Access::compute_sample, Access::fragment_sample, Access::depth_test,
                               Access::transfer_read, Access::host_read};
constexpr std::array kWriting{Access::compute_storage, Access::color_attachment, Access::depth_attachment,
                              Access::transfer_write};

// All flags of Vulkan 1.3 that write.
constexpr VkAccessFlags2 kAnyWrite = VK_ACCESS_2_SHADER_WRITE_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT |
                                     VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
                                     VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT |
                                     VK_ACCESS_2_HOST_WRITE_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;

TEST(AccessInfo, ReadOnlyAccessesNeverWrite) {
  for (const Access access : kReadOnly)
    for (const bool depth : {false, true}) {
      const AccessInfo info = access_info(access, depth);
      EXPECT_EQ(info.writes, 0u) << static_cast<int>(access);
      EXPECT_NE(info.reads, 0u) << static_cast<int>(access);
      EXPECT_NE(info.stages, 0u) << static_cast<int>(access);
    }
}

TEST(AccessInfo, ReadsAndWritesAreNeverMixedUp) {
  for (const Access access : kReadOnly) EXPECT_EQ(access_info(access, false).reads & kAnyWrite, 0u);
  for (const Access access : kWriting) {
    const AccessInfo info = access_info(access, false);
    EXPECT_EQ(info.reads & kAnyWrite, 0u) << static_cast<int>(access);
    EXPECT_NE(info.writes, 0u) << static_cast<int>(access);
    EXPECT_EQ(info.writes & ~kAnyWrite, 0u) << static_cast<int>(access);
  }
}

TEST(AccessInfo, DepthIsSampledAndTestedInOneLayout) {
  const auto tested = access_info(Access::depth_test, true).layout;
  EXPECT_EQ(tested, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL);
  EXPECT_EQ(access_info(Access::compute_sample, true).layout, tested);
  EXPECT_EQ(access_info(Access::fragment_sample, true).layout, tested);
  EXPECT_EQ(access_info(Access::compute_sample, false).layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

}  // namespace
}  // namespace velarium::graph
