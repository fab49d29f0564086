#include "graph/history.hpp"

#include "gpu/barrier.hpp"
#include "graph/graph.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

namespace velarium::graph {
namespace {

// Whatever a frame uses its image for, the next one may sample or copy it, and the executor may clear it.
constexpr VkImageUsageFlags kAlways =
    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;

void fit(gpu::Device& device, gpu::Image& image, const gpu::ImageDesc& desc, VkImageUsageFlags usage) {
  if (image && image.desc() == desc && (usage & ~image.usage()) == 0) return;
  const VkImageUsageFlags before = image && image.desc() == desc ? image.usage() : 0;
  device.wait();
  image = {};  // first: the old one and the new one need not fit beside each other
  image = gpu::Image(device, desc, usage | before);
}

void clear_to_zero(VkCommandBuffer commands, gpu::Image& image) {
  constexpr VkImageLayout kLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  gpu::record(commands,
              gpu::image_barrier(image, gpu::kAllWork, gpu::kTransferWrite, {VK_IMAGE_LAYOUT_UNDEFINED, kLayout}));
  const VkFormat format = image.desc().format;
  const VkImageSubresourceRange all{gpu::aspects(format), 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
  if (gpu::has_depth(format)) {
    const VkClearDepthStencilValue zero{};
    vkCmdClearDepthStencilImage(commands, image.vk(), kLayout, &zero, 1, &all);
  } else {
    const VkClearColorValue zero{};
    vkCmdClearColorImage(commands, image.vk(), kLayout, &zero, 1, &all);
  }
  image.layout = kLayout;
}

}  // namespace

HistoryStore::Pair& HistoryStore::pair(const std::string& name) {
  auto& found = pairs_[name];
  if (found.state == 0) found.state = ++states_;
  return found;
}

void HistoryStore::refuse_outdated(const Graph& graph) const {
  for (const auto& history : graph.histories()) {
    const auto found = pairs_.find(history.name);
    if (found == pairs_.end() || found->second.state != history.state)
      throw Error(ErrorCode::internal,
                  fmt::format("history '{}' has changed since the graph that runs was declared", history.name));
  }
}

void HistoryStore::allocate(gpu::Device& device, const Graph& graph, std::uint64_t run) {
  for (const auto& history : graph.histories()) {
    auto& pair = pairs_.at(history.name);
    const auto& current = graph.images()[history.current];
    if (pair.desc != current.desc) pair.has_contents = false;
    pair.desc = current.desc;
    pair.declared_in = run;
    fit(device, pair.newest(), current.desc, kAlways);
    fit(device, pair.next(), current.desc, kAlways | current.usage);
  }
}

void HistoryStore::clear_missing(const Graph& graph, VkCommandBuffer commands) const {
  for (const auto& history : graph.histories()) {
    const auto& previous = graph.images()[history.previous];
    if (!history.has_contents && previous.usage != 0) clear_to_zero(commands, *previous.imported);
  }
}

void HistoryStore::advance(const Graph& graph) {
  for (const auto& history : graph.histories()) {
    auto& pair = pairs_.at(history.name);
    pair.current = 1 - pair.current;
    pair.has_contents = true;
    pair.state = ++states_;
  }
}

void HistoryStore::forget() {
  for (auto& [name, pair] : pairs_) {
    pair.has_contents = false;
    pair.state = ++states_;
  }
}

void HistoryStore::free_declared_until(std::uint64_t run) {
  std::erase_if(pairs_, [run](const auto& named) { return named.second.declared_in <= run; });
}

}  // namespace velarium::graph
