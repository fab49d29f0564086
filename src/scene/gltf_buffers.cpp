#include "scene/gltf_buffers.hpp"

#include "scene/gltf_meshopt.hpp"
#include "scene/gltf_uri.hpp"

#include <fmt/core.h>

#include <limits>
#include <optional>

namespace velarium::scene::gltf {

namespace {
constexpr std::uint64_t kAnyLength = std::numeric_limits<std::int64_t>::max();

// glTF 2.0, bufferView.byteStride: from 4 to 252, a multiple of 4. Devices may ask that; this reader can do with any,
// and takes 0 as OpenGL does, for elements without a gap.
std::optional<std::uint32_t> read_stride(const Value& value) {
  if (!value) return std::nullopt;
  constexpr std::uint32_t kLeast = 4, kMost = 252;
  const auto stride = static_cast<std::uint32_t>(value.integer(0, std::numeric_limits<std::uint32_t>::max()));
  if (stride == 0) {
    value.repair("is 0; elements follow each other without a gap");
    return std::nullopt;
  }
  if (stride < kLeast || stride > kMost || stride % 4 != 0)
    value.repair(fmt::format("is {}, not a multiple of 4 from {} to {}; it was used", stride, kLeast, kMost));
  return stride;
}

}  // namespace

Buffers::Buffers(Value root, const Container& container, const GltfOptions& options)
    : bytes_("load.bytes", options.limits.bytes) {
  const std::vector<Value> buffers = root["buffers"].elements();
  for (std::uint32_t i = 0; i < buffers.size(); ++i) read_buffer(buffers[i], i, container, options);
  for (const Value& view : root["bufferViews"].elements()) read_view(view);
}

void Buffers::read_buffer(const Value& buffer, std::uint32_t index, const Container& container,
                          const GltfOptions& options) {
  const std::uint64_t length = buffer.require("byteLength").integer(1, kAnyLength);
  std::span<const std::byte> bytes;
  if (const Value uri = buffer["uri"]) {
    owned_.push_back(read_uri(find_uri(uri, options, bytes_)));
    bytes = owned_.back();
  } else if (index == 0 && container.binary && !is_meshopt_fallback(buffer)) {
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

// Of a view, or of the extension's object in it, which says it alike.
Buffers::Range Buffers::read_range(const Value& view) const {
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
  return {buffer.data ? buffer.data + offset : nullptr, offset, length};
}

void Buffers::read_view(const Value& view) {
  const Range range = read_range(view);
  BufferView& added = views_.emplace_back();
  added.data = range.data;
  added.length = range.length;
  added.offset = range.offset;
  added.stride = read_stride(view["byteStride"]);
  if (const Value compressed = meshopt_extension(view)) decompress(compressed, added);
}

void Buffers::decompress(const Value& extension, BufferView& view) {
  const Range compressed = read_range(extension);
  const MeshoptView layout = read_meshopt_view(extension, view.length);
  if (view.stride && *view.stride != layout.stride) {
    extension["byteStride"].fail(fmt::format("is {}, but the view's own is {}", layout.stride, *view.stride));
  }
  if (!compressed.data) extension["buffer"].fail("has no data");
  if (!bytes_.fits(view.length)) extension.fail("with it there are " + bytes_.refusal(view.length));
  owned_.push_back(decode_meshopt(layout, {compressed.data, compressed.length}));
  bytes_.spend(view.length);
  view.data = owned_.back().data();
}

const BufferView& Buffers::view(const Value& reference) const {
  return views_[reference.reference(static_cast<std::uint32_t>(views_.size()), "bufferViews")];
}

}  // namespace velarium::scene::gltf
