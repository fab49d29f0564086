#include "graph/access.hpp"

namespace velarium::graph {
namespace {

constexpr VkPipelineStageFlags2 kDepthTests =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr VkAccessFlags2 kShaderRead =
    VK_ACCESS_2_SHADER_SAMPLED_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_UNIFORM_READ_BIT;
constexpr VkBufferUsageFlags kShaderBuffer = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

}  // namespace

AccessInfo access_info(Access access, bool depth) {
  const VkImageLayout sampled_layout =
      depth ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  switch (access) {
    case Access::compute_sample:
      return {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
              kShaderRead,
              0,
              sampled_layout,
              VK_IMAGE_USAGE_SAMPLED_BIT,
              kShaderBuffer};
    case Access::compute_storage:
      return {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
              VK_ACCESS_2_SHADER_STORAGE_READ_BIT,
              VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
              VK_IMAGE_LAYOUT_GENERAL,
              VK_IMAGE_USAGE_STORAGE_BIT,
              kShaderBuffer};
    case Access::fragment_sample:
      return {VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
              kShaderRead,
              0,
              sampled_layout,
              VK_IMAGE_USAGE_SAMPLED_BIT,
              kShaderBuffer};
    case Access::color_attachment:
      return {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
              VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT,
              VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
              VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
              VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
              0};
    case Access::depth_attachment:
      return {kDepthTests,
              VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
              VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
              VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
              VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
              0};
    case Access::depth_test:
      return {kDepthTests,
              VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
              0,
              VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL,
              VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
              0};
    case Access::transfer_read:
      return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,   0,
              VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_USAGE_TRANSFER_SRC_BIT, VK_BUFFER_USAGE_TRANSFER_SRC_BIT};
    case Access::transfer_write:
      return {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, 0,
              VK_ACCESS_2_TRANSFER_WRITE_BIT,       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
              VK_IMAGE_USAGE_TRANSFER_DST_BIT,      VK_BUFFER_USAGE_TRANSFER_DST_BIT};
    case Access::host_read:
      return {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT, 0, VK_IMAGE_LAYOUT_GENERAL, 0, 0};
  }
  return {};
}

}  // namespace velarium::graph
