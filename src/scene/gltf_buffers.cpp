#include "scene/gltf_buffers.hpp"

#include "scene/gltf_uri.hpp"

#include <fmt/core.h>

#include <limits>

namespace velarium::scene::gltf {

namespace {
constexpr std::uint64_t kAnyLength = std::numeric_limits<std::int64_t>::max();
// glTF 2.0, bufferView.byteStride.
constexpr std::uint32_t kMinStride = 4, kMaxStride = 252;
}  // namespace

Buffers::Buffers(Value root, const Container& container, const GltfOptions& options)
    : bytes_left_(options.limits.file_bytes) {
  const std::vector<Value> buffers = root["buffers"].elements();
  for (std::uint32_t i = 0; i < buffers.size(); ++i) read_buffer(buffers[i], i, container, options);
  for (const Value& view : root["bufferViews"].elements()) read_view(view);
}

void Buffers::read_buffer(const Value& buffer, std::uint32_t index, const Container& container,
                          const GltfOptions& options) {
  const std::uint64_t length = buffer.require("byteLength").integer(1, kAnyLength);
  std::span<const std::byte> bytes;
  if (const Value uri = buffer["uri"]) {
    owned_.push_back(load_uri(uri, options, bytes_left_));
    bytes = owned_.back();
    bytes_left_ -= bytes.size();
  } else if (index == 0 && container.binary) {
    bytes = *container.binary;
  } else {
    buffers_.push_back({nullptr, length});
    return;
  }
  if (bytes.size() < length) {
    buffer.fail(fmt::format("holds {} bytes, fewer than its byteLength of {}", bytes.size(), length));
  }
  buffers_.push_back({bytes.data(), length});
}

void Buffers::read_view(const Value& view) {
  const Value reference = view.require("buffer");
  const std::uint32_t index = reference.reference(static_cast<std::uint32_t>(buffers_.size()), "buffers");
  const Buffer& buffer = buffers_[index];
  const std::uint64_t offset = view["byteOffset"].integer_or(0, 0, kAnyLength);
  const std::uint64_t length = view.require("byteLength").integer(1, kAnyLength);
  if (offset >= buffer.length) {
    view["byteOffset"].fail(fmt::format("is {}, beyond /buffers/{} of {} bytes", offset, index, buffer.length));
  }
  if (length > buffer.length - offset) {
    view["byteLength"].fail(fmt::format("bytes {} to {} do not fit /buffers/{} of {} bytes", offset, offset + length,
                                        index, buffer.length));
  }
  BufferView& added = views_.emplace_back();
  added.data = buffer.data ? buffer.data + offset : nullptr;
  added.length = length;
  added.offset = offset;
  if (const Value stride = view["byteStride"]) {
    added.stride = static_cast<std::uint32_t>(stride.integer(kMinStride, kMaxStride));
    if (*added.stride % 4 != 0) stride.fail(fmt::format("is {}, must be a multiple of 4", *added.stride));
  }
}

const BufferView& Buffers::view(const Value& reference) const {
  return views_[reference.reference(static_cast<std::uint32_t>(views_.size()), "bufferViews")];
}

}  // namespace velarium::scene::gltf
