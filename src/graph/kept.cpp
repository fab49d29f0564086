#include "graph/kept.hpp"

namespace velarium::graph {

gpu::Image& KeptResources::image(const Graph::ImageResource& resource, std::uint64_t run) {
  auto& kept = images_[resource.name];
  kept.declared_in = run;
  // Anything may be copied out by --dump.
  const VkImageUsageFlags usage = resource.usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  if (!kept.image || kept.image.desc() != resource.desc || kept.image.usage() != usage) {
    device_.wait();
    kept.image = {};  // first: the old one and the new one need not fit beside each other
    kept.image = gpu::Image(device_, resource.desc, usage);
  }
  return kept.image;
}

gpu::Buffer& KeptResources::buffer(const Graph::BufferResource& resource, std::size_t slot, std::uint64_t run) {
  auto& kept = buffers_[resource.use == gpu::MemoryUse::device ? 0 : slot][resource.name];
  kept.declared_in = run;
  if (kept.buffer.size() < resource.bytes || kept.usage != resource.usage || kept.use != resource.use) {
    device_.wait();
    kept.buffer = gpu::Buffer(device_, resource.bytes, resource.usage, resource.use);
    kept.usage = resource.usage;
    kept.use = resource.use;
  }
  return kept.buffer;
}

std::vector<KeptImage> KeptResources::images(std::uint64_t last_run) const {
  std::vector<KeptImage> result;
  for (const auto& [name, kept] : images_)
    if (kept.image) result.push_back({name, kept.image.bytes(), kept.declared_in == last_run});
  return result;
}

void KeptResources::free_declared_until(std::uint64_t run) {
  const auto is_old = [run](const auto& named) { return named.second.declared_in <= run; };
  std::erase_if(images_, is_old);
  for (auto& buffers : buffers_) std::erase_if(buffers, is_old);
}

}  // namespace velarium::graph
