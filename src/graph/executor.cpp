#include "graph/executor.hpp"

#include "gpu/barrier.hpp"
#include "graph/context.hpp"

#include <algorithm>

namespace velarium::graph {
void Executor::run(const Graph& graph, bool paranoid) {
  allocate(graph);
  tools_.descriptors.reset();
  const VkCommandBuffer commands = tools_.device.begin();
  record(graph, commands, paranoid);
  tools_.device.submit_and_wait(commands);
}

void Executor::allocate(const Graph& graph) {
  image_list_.clear();
  image_names_.clear();
  for (const auto& resource : graph.images()) {
    gpu::Image* image = resource.imported;
    if (image == nullptr) {
      image = &images_[resource.name];
      // Anything may be copied out by --dump.
      const VkImageUsageFlags usage = resource.usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
      if (!*image || image->desc() != resource.desc || image->usage() != usage) {
        *image = {};  // first: the old one and the new one need not fit beside each other
        *image = gpu::Image(tools_.device, resource.desc, usage);
      }
    }
    image_list_.push_back(image);
    image_names_.push_back(resource.name);
  }
  buffer_list_.clear();
  for (const auto& resource : graph.buffers()) {
    auto& kept = buffers_[resource.name];
    if (kept.buffer.size() < resource.bytes || kept.usage != resource.usage || kept.use != resource.use)
      kept = {resource.usage, resource.use, gpu::Buffer(tools_.device, resource.bytes, resource.usage, resource.use)};
    if (!resource.contents.empty()) std::ranges::copy(resource.contents, kept.buffer.mapped().begin());
    buffer_list_.push_back(&kept.buffer);
  }
}

void Executor::record(const Graph& graph, VkCommandBuffer commands, bool paranoid) {
  const auto planned = plan(graph);
  const auto pass_count = static_cast<std::uint32_t>(graph.passes().size());
  timers_.begin(commands, pass_count);
  pass_names_.clear();
  Context context(tools_, commands, image_list_, buffer_list_);
  for (std::uint32_t i = 0; i < pass_count; ++i) {
    const auto& pass = graph.passes()[i];
    pass_names_.push_back(pass.name());
    begin_label(commands, pass.name());
    // Before the barriers: a software driver may put a timestamp off until a barrier makes it finish what it has.
    timers_.start(commands, i);
    barriers(commands, planned[i], paranoid);
    if (pass.record()) pass.record()(context);
    timers_.stop(commands, i);
    end_label(commands);
    for (const auto& barrier : planned[i].images) image_list_[barrier.index]->layout = barrier.new_layout;
  }
}

void Executor::barriers(VkCommandBuffer commands, const PlannedPass& planned, bool paranoid) const {
  std::vector<VkImageMemoryBarrier2> images;
  for (const auto& b : planned.images) {
    const auto& image = *image_list_[b.index];
    const auto before = paranoid ? gpu::kAllWork : gpu::Scope{b.src_stages, b.src_access};
    const auto after = paranoid ? gpu::kAllWork : gpu::Scope{b.dst_stages, b.dst_access};
    images.push_back(gpu::image_barrier(image, before, after, {b.old_layout, b.new_layout}));
  }
  std::vector<VkBufferMemoryBarrier2> buffers;
  for (const auto& b : planned.buffers)
    buffers.push_back({.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2,
                       .srcStageMask = b.src_stages,
                       .srcAccessMask = b.src_access,
                       .dstStageMask = b.dst_stages,
                       .dstAccessMask = b.dst_access,
                       .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                       .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
                       .buffer = buffer_list_[b.index]->vk(),
                       .size = VK_WHOLE_SIZE});
  if (!paranoid && images.empty() && buffers.empty()) return;
  constexpr VkMemoryBarrier2 kFull = gpu::memory_barrier(gpu::kAllWork, gpu::kAllWork);
  const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                              .memoryBarrierCount = paranoid ? 1u : 0u,
                              .pMemoryBarriers = &kFull,
                              .bufferMemoryBarrierCount = static_cast<std::uint32_t>(buffers.size()),
                              .pBufferMemoryBarriers = buffers.data(),
                              .imageMemoryBarrierCount = static_cast<std::uint32_t>(images.size()),
                              .pImageMemoryBarriers = images.data()};
  vkCmdPipelineBarrier2(commands, &info);
}

void Executor::begin_label(VkCommandBuffer commands, const std::string& name) const {
  if (!tools_.device.has_labels()) return;
  const VkDebugUtilsLabelEXT label{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT, .pLabelName = name.c_str()};
  vkCmdBeginDebugUtilsLabelEXT(commands, &label);
}

void Executor::end_label(VkCommandBuffer commands) const {
  if (tools_.device.has_labels()) vkCmdEndDebugUtilsLabelEXT(commands);
}

std::vector<PassTiming> Executor::timings() const {
  const auto ms = timers_.read();
  std::vector<PassTiming> result;
  for (std::size_t i = 0; i < ms.size(); ++i) result.push_back({pass_names_[i], ms[i]});
  return result;
}

double Executor::frame_ms() const {
  double sum = 0;
  for (const auto& pass : timings()) sum += pass.ms;
  return sum;
}

gpu::Image* Executor::find_image(const std::string& name) {
  const auto found = std::find(image_names_.begin(), image_names_.end(), name);
  return found == image_names_.end() ? nullptr : image_list_[static_cast<std::size_t>(found - image_names_.begin())];
}

std::vector<std::string> Executor::image_names() const {
  return image_names_;
}

std::uint64_t Executor::kept_bytes(const std::string& name) const {
  const auto kept = images_.find(name);
  return kept == images_.end() ? 0 : kept->second.bytes();
}

void Executor::drop(const std::string& name) {
  image_list_.clear();
  image_names_.clear();
  images_.erase(name);
}

}  // namespace velarium::graph
