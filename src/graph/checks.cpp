#include "graph/checks.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace velarium::graph {
namespace {

template <class... Args>
[[noreturn]] void refuse(fmt::format_string<Args...> message, Args&&... args) {
  throw Error(ErrorCode::internal, fmt::format(message, std::forward<Args>(args)...));
}

// How messages call what the handle names.
std::string called(GraphImage handle, const Graph::ImageResource& image) {
  return handle.mip == gpu::kAllMips ? fmt::format("'{}'", image.name)
                                     : fmt::format("mip {} of '{}'", handle.mip, image.name);
}

void refuse_version(const Pass& pass, std::uint32_t version, std::uint32_t newest, const std::string& resource) {
  if (version != newest)
    refuse("pass '{}' uses version {} of {}, whose newest is {}", pass.name(), version, resource, newest);
}

}  // namespace

void refuse_stale(const Pass& pass, GraphImage handle, const Graph::ImageResource& image, bool needs_contents) {
  const auto named = mips_of(handle.mip, image.desc.mips);
  const auto* first = image.mip_versions.data() + named.first;
  const auto newest = *std::max_element(first, first + named.count);
  // A handle from before other mips were written is as good as a newer one.
  if (handle.version < newest || handle.version > image.version)
    refuse_version(pass, handle.version, newest, called(handle, image));
  if (!needs_contents) return;
  const auto* unwritten = std::find(first, first + named.count, 0u);
  if (unwritten == first + named.count) return;
  const bool whole = newest == 0 && handle.mip == gpu::kAllMips;
  const auto mip = static_cast<std::uint32_t>(unwritten - image.mip_versions.data());
  refuse("pass '{}' reads {} before any pass wrote it", pass.name(), called(whole ? handle : handle.at(mip), image));
}

void refuse_stale(const Pass& pass, GraphBuffer handle, const Graph::BufferResource& buffer, bool needs_contents) {
  refuse_version(pass, handle.version, buffer.version, fmt::format("'{}'", buffer.name));
  if (needs_contents && handle.version == 0)
    refuse("pass '{}' reads '{}' before any pass wrote it", pass.name(), buffer.name);
}

void refuse_misfit(const Pass& pass, GraphImage handle, const Graph::ImageResource& image, const AccessInfo& access) {
  const auto& desc = image.desc;
  if (handle.mip != gpu::kAllMips && handle.mip >= desc.mips)
    refuse("pass '{}' uses {}, which has {}", pass.name(), called(handle, image), desc.mips);
  constexpr VkImageUsageFlags kTarget =
      VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  const bool target = (access.image_usage & kTarget) != 0;
  if (target && desc.depth > 1) refuse("pass '{}' has the 3-D image '{}' as a target", pass.name(), image.name);
  if (target && desc.mips > 1 && handle.mip == gpu::kAllMips)
    refuse("pass '{}' has all mips of '{}' as one target", pass.name(), image.name);
  constexpr VkImageUsageFlags kReads = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  if (image.is_previous && (access.image_usage & ~kReads) != 0)
    refuse("pass '{}' may only sample or copy '{}', which is the frame before", pass.name(), image.name);
}

void refuse_read_only(const Pass& pass, const AccessInfo& access, const std::string& resource) {
  if (access.writes == 0) refuse("pass '{}' writes '{}' by an access that only reads", pass.name(), resource);
}

void refuse_same_name(const Pass& pass, bool taken, const std::string& name) {
  if (taken) refuse("pass '{}' makes two resources named '{}'", pass.name(), name);
}

}  // namespace velarium::graph
