#include "gpu/barrier.hpp"
#include "shading/host.hpp"
#include "upload/normal_mips.hpp"

#include <algorithm>

namespace velarium::upload {
namespace {

namespace io {
using namespace shading;
#include "upload/normal_mips_io.glsl"
}  // namespace io

constexpr std::uint32_t kShader[] =
#include "shaders/upload/normal_mips.comp.inc"
    ;
constexpr std::uint32_t kGroupSize = 2 * 8;  // texels: each thread makes two by two
constexpr VkDeviceSize kMeanBytes = 16;

std::uint32_t groups(std::uint32_t texels) {
  return (texels + kGroupSize - 1) / kGroupSize;
}

std::uint32_t mip_size(std::uint32_t size, std::uint32_t mip) {
  return std::max(size >> mip, 1u);
}

// Texels of all levels but the first.
std::uint32_t mean_count(const gpu::ImageDesc& desc) {
  std::uint32_t count = 0;
  for (std::uint32_t mip = 1; mip < desc.mips; ++mip) count += mip_size(desc.width, mip) * mip_size(desc.height, mip);
  return count;
}

void wait_for_stores(VkCommandBuffer commands) {
  constexpr VkPipelineStageFlags2 kCompute = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
  constexpr gpu::Scope kStored{kCompute, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
  constexpr gpu::Scope kRead{kCompute, VK_ACCESS_2_SHADER_STORAGE_READ_BIT};
  gpu::record(commands, gpu::memory_barrier(kStored, kRead));
}

}  // namespace

void NormalMipmapper::record(VkCommandBuffer commands, const gpu::Image& image) {
  const auto& desc = image.desc();
  if (desc.mips == 1) return;
  const auto& pipeline = tools_.pipelines.compute(kShader);
  const auto& means = means_.emplace_back(tools_.device, kMeanBytes * mean_count(desc),
                                          VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::MemoryUse::device);
  vkCmdBindPipeline(commands, pipeline.bind_point(), pipeline.vk());
  std::uint32_t above = 0, first = 0;
  for (std::uint32_t mip = 1; mip < desc.mips; ++mip) {
    const io::NormalMipPush push{.from_size = {mip_size(desc.width, mip - 1), mip_size(desc.height, mip - 1)},
                                 .to_size = {mip_size(desc.width, mip), mip_size(desc.height, mip)},
                                 .from_first = above,
                                 .to_first = first,
                                 .from_base = mip == 1 ? 1u : 0u};
    const auto bindings = gpu::Bindings()
                              .storage(io::base, image.mip_view(0))
                              .storage(io::level, image.mip_view(mip))
                              .buffer(io::MeansBuffer, means);
    const VkDescriptorSet set = tools_.descriptors.make(pipeline, 0, bindings);
    if (mip > 1) wait_for_stores(commands);
    vkCmdBindDescriptorSets(commands, pipeline.bind_point(), pipeline.layout(), 0, 1, &set, 0, nullptr);
    vkCmdPushConstants(commands, pipeline.layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof push, &push);
    vkCmdDispatch(commands, groups(push.to_size.x), groups(push.to_size.y), 1);
    above = first;
    first += push.to_size.x * push.to_size.y;
  }
}

void NormalMipmapper::reset() {
  means_.clear();
  tools_.descriptors.reset();
}

}  // namespace velarium::upload
