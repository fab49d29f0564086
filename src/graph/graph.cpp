#include "graph/graph.hpp"

#include "graph/checks.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace velarium::graph {
namespace {

template <class Resource>
bool is_taken(const std::vector<Resource>& resources, const std::string& full_name) {
  return std::any_of(resources.begin(), resources.end(),
                     [&](const Resource& other) { return other.has_full_name && other.name == full_name; });
}

// The first write gives a resource its full name, under which the executor keeps it and --dump finds it.
template <class Resource>
void name_on_first_write(const Pass& pass, std::vector<Resource>& resources, std::uint32_t index) {
  auto& resource = resources[index];
  if (resource.has_full_name) return;
  const std::string name = pass.name() + "." + resource.name;
  refuse_same_name(pass, is_taken(resources, name), name);
  resource.name = name;
  resource.has_full_name = true;
}

}  // namespace

Graph::Scope::Scope(Graph& graph, std::string_view name) : graph_(graph), outer_length_(graph.prefix_.size()) {
  if (!name.empty()) graph.prefix_ += std::string(name) + "/";
}

Graph::Scope::~Scope() {
  graph_.prefix_.resize(outer_length_);
}

GraphImage Graph::add(ImageResource resource) {
  resource.mip_versions.assign(resource.desc.mips, resource.version);
  images_.push_back(std::move(resource));
  return {static_cast<std::uint32_t>(images_.size() - 1), images_.back().version};
}

GraphImage Graph::image(std::string_view name, const gpu::ImageDesc& desc) {
  return add({.name = std::string(name), .desc = desc});
}

GraphImage Graph::import(std::string_view name, gpu::Image& image, bool initialized) {
  return add({.name = (initialized ? prefix_ : std::string()).append(name),
              .has_full_name = initialized,
              .desc = image.desc(),
              .imported = &image,
              .version = initialized ? 1u : 0u});
}

GraphBuffer Graph::buffer(std::string_view name, VkDeviceSize bytes, gpu::MemoryUse use) {
  buffers_.push_back({.name = std::string(name), .bytes = bytes, .use = use});
  return {static_cast<std::uint32_t>(buffers_.size() - 1), 0};
}

GraphBuffer Graph::import(std::string_view name, gpu::Buffer& buffer, bool initialized) {
  const std::uint32_t version = initialized ? 1 : 0;
  buffers_.push_back({.name = (initialized ? prefix_ : std::string()).append(name),
                      .has_full_name = initialized,
                      .bytes = buffer.size(),
                      .imported = &buffer,
                      .version = version});
  return {static_cast<std::uint32_t>(buffers_.size() - 1), version};
}

GraphBuffer Graph::upload(std::string_view name, std::span<const std::byte> bytes) {
  const std::string full_name = prefix_ + std::string(name);
  if (is_taken(buffers_, full_name))
    throw Error(ErrorCode::internal, fmt::format("table '{}' is the second buffer of that name", full_name));
  buffers_.push_back({.name = full_name,
                      .has_full_name = true,
                      .bytes = bytes.size(),
                      .use = gpu::MemoryUse::upload,
                      .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                      .version = 1,
                      .contents = {bytes.begin(), bytes.end()}});
  return {static_cast<std::uint32_t>(buffers_.size() - 1), 1};
}

History Graph::history(std::string_view name, const gpu::ImageDesc& desc) {
  const std::string full_name = prefix_ + std::string(name);
  if (history_ == nullptr)
    throw Error(ErrorCode::internal,
                fmt::format("history '{}' in a graph that was made without the executor's history", full_name));
  if (is_taken(images_, full_name))
    throw Error(ErrorCode::internal, fmt::format("history '{}' is the second image of that name", full_name));
  auto& pair = history_->pair(full_name);
  History result;
  result.has_contents = pair.has_contents && pair.desc == desc;
  result.previous = add({.name = full_name + ".previous",
                         .has_full_name = true,
                         .desc = desc,
                         .imported = &pair.newest(),
                         .is_previous = true,
                         .version = 1});
  result.current = add({.name = full_name, .has_full_name = true, .desc = desc, .imported = &pair.next()});
  histories_.push_back({full_name, result.previous.index, result.current.index, result.has_contents, pair.state});
  return result;
}

Pass& Graph::pass(std::string_view name) {
  return passes_.emplace_back(*this, prefix_ + std::string(name));
}

Pass& Pass::read(GraphImage image, Access access) {
  auto& resource = graph_.images_.at(image.index);
  const AccessInfo info = access_info(access, gpu::has_depth(resource.desc.format));
  refuse_misfit(*this, image, resource, info);
  refuse_stale(*this, image, resource, true);
  resource.usage |= info.image_usage;
  image_uses_.push_back({image.index, access, false, image.mip});
  return *this;
}

Pass& Pass::read(GraphBuffer buffer, Access access) {
  auto& resource = graph_.buffers_.at(buffer.index);
  refuse_stale(*this, buffer, resource, true);
  resource.usage |= access_info(access, false).buffer_usage;
  buffer_uses_.push_back({buffer.index, access, false});
  return *this;
}

GraphImage Pass::write(GraphImage image, Access access) {
  auto& resource = graph_.images_.at(image.index);
  const AccessInfo info = access_info(access, gpu::has_depth(resource.desc.format));
  refuse_misfit(*this, image, resource, info);
  refuse_stale(*this, image, resource, false);
  refuse_read_only(*this, info, resource.name);
  name_on_first_write(*this, graph_.images_, image.index);
  resource.usage |= info.image_usage;
  image_uses_.push_back({image.index, access, true, image.mip});
  ++resource.version;
  const auto written = mips_of(image.mip, resource.desc.mips);
  std::fill_n(resource.mip_versions.begin() + written.first, written.count, resource.version);
  return {image.index, resource.version, image.mip};
}

GraphBuffer Pass::write(GraphBuffer buffer, Access access) {
  auto& resource = graph_.buffers_.at(buffer.index);
  refuse_stale(*this, buffer, resource, false);
  const AccessInfo info = access_info(access, false);
  refuse_read_only(*this, info, resource.name);
  name_on_first_write(*this, graph_.buffers_, buffer.index);
  resource.usage |= info.buffer_usage;
  buffer_uses_.push_back({buffer.index, access, true});
  return {buffer.index, ++resource.version};
}

}  // namespace velarium::graph
