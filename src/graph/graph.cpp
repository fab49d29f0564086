#include "graph/graph.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

namespace velarium::graph {
namespace {

// Shared by images and buffers: a handle must name the newest version, and a read needs one that was written.
template <class Handle, class Resource>
void refuse_stale(const Pass& pass, Handle handle, const std::vector<Resource>& resources, bool needs_contents) {
  const auto& resource = resources.at(handle.index);
  if (handle.version != resource.version)
    throw Error(ErrorCode::internal, fmt::format("pass '{}' uses version {} of '{}', whose newest is {}", pass.name(),
                                                 handle.version, resource.name, resource.version));
  if (needs_contents && handle.version == 0)
    throw Error(ErrorCode::internal,
                fmt::format("pass '{}' reads '{}' before any pass wrote it", pass.name(), resource.name));
}

void refuse_read_only(const Pass& pass, const AccessInfo& access, const std::string& resource) {
  if (access.writes == 0)
    throw Error(ErrorCode::internal,
                fmt::format("pass '{}' writes '{}' by an access that only reads", pass.name(), resource));
}

template <class Resource>
void refuse_twice(std::string_view name, const std::string& maker, const std::vector<Resource>& resources) {
  for (const auto& other : resources)
    if (other.name == name)
      throw Error(ErrorCode::internal, fmt::format("{} makes two resources named '{}'", maker, name));
}

// The first write gives a resource its full name, under which the executor keeps it and --dump finds it.
template <class Resource>
void name_on_first_write(const Pass& pass, std::vector<Resource>& resources, std::uint32_t index) {
  if (resources[index].version != 0) return;
  const std::string name = pass.name() + "." + resources[index].name;
  refuse_twice(name, "pass '" + pass.name() + "'", resources);
  resources[index].name = name;
}

}  // namespace

GraphImage Graph::image(std::string_view name, const gpu::ImageDesc& desc) {
  images_.push_back({.name = std::string(name), .desc = desc});
  return {static_cast<std::uint32_t>(images_.size() - 1), 0};
}

GraphImage Graph::import(std::string_view name, gpu::Image& image, bool initialized) {
  const std::uint32_t version = initialized ? 1 : 0;
  images_.push_back({.name = std::string(name), .desc = image.desc(), .imported = &image, .version = version});
  return {static_cast<std::uint32_t>(images_.size() - 1), version};
}

GraphBuffer Graph::buffer(std::string_view name, VkDeviceSize bytes, gpu::MemoryUse use) {
  buffers_.push_back({.name = std::string(name), .bytes = bytes, .use = use});
  return {static_cast<std::uint32_t>(buffers_.size() - 1), 0};
}

GraphBuffer Graph::upload(std::string_view name, std::span<const std::byte> bytes) {
  refuse_twice(name, "the graph", buffers_);
  buffers_.push_back({.name = std::string(name),
                      .bytes = bytes.size(),
                      .use = gpu::MemoryUse::upload,
                      .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                      .version = 1,
                      .contents = {bytes.begin(), bytes.end()}});
  return {static_cast<std::uint32_t>(buffers_.size() - 1), 1};
}

Pass& Graph::pass(std::string_view name) {
  return passes_.emplace_back(*this, name);
}

Pass& Pass::read(GraphImage image, Access access) {
  refuse_stale(*this, image, graph_.images_, true);
  auto& resource = graph_.images_[image.index];
  resource.usage |= access_info(access, gpu::has_depth(resource.desc.format)).image_usage;
  image_uses_.push_back({image.index, access, false});
  return *this;
}

Pass& Pass::read(GraphBuffer buffer, Access access) {
  refuse_stale(*this, buffer, graph_.buffers_, true);
  graph_.buffers_[buffer.index].usage |= access_info(access, false).buffer_usage;
  buffer_uses_.push_back({buffer.index, access, false});
  return *this;
}

GraphImage Pass::write(GraphImage image, Access access) {
  refuse_stale(*this, image, graph_.images_, false);
  auto& resource = graph_.images_[image.index];
  const AccessInfo info = access_info(access, gpu::has_depth(resource.desc.format));
  refuse_read_only(*this, info, resource.name);
  name_on_first_write(*this, graph_.images_, image.index);
  resource.usage |= info.image_usage;
  image_uses_.push_back({image.index, access, true});
  return {image.index, ++resource.version};
}

GraphBuffer Pass::write(GraphBuffer buffer, Access access) {
  refuse_stale(*this, buffer, graph_.buffers_, false);
  auto& resource = graph_.buffers_[buffer.index];
  const AccessInfo info = access_info(access, false);
  refuse_read_only(*this, info, resource.name);
  name_on_first_write(*this, graph_.buffers_, buffer.index);
  resource.usage |= info.buffer_usage;
  buffer_uses_.push_back({buffer.index, access, true});
  return {buffer.index, ++resource.version};
}

}  // namespace velarium::graph
