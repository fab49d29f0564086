#include "scene/gltf_meshopt.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <meshoptimizer.h>

#include <limits>

namespace velarium::scene::gltf {

namespace {

using Mode = MeshoptView::Mode;
using Filter = MeshoptView::Filter;

Value either_name(const Value& extensions) {
  const Value vendor = extensions["EXT_meshopt_compression"];
  return vendor ? vendor : extensions["KHR_meshopt_compression"];
}

Mode read_mode(const Value& value) {
  const std::string_view name = value.text();
  if (name == "ATTRIBUTES") return Mode::attributes;
  if (name == "TRIANGLES") return Mode::triangles;
  if (name == "INDICES") return Mode::indices;
  value.fail(fmt::format("is '{}', must be ATTRIBUTES, TRIANGLES or INDICES", name));
}

Filter read_filter(const Value& value) {
  const std::string name = value.text_or("NONE");
  if (name == "NONE") return Filter::none;
  if (name == "OCTAHEDRAL") return Filter::octahedral;
  if (name == "QUATERNION") return Filter::quaternion;
  if (name == "EXPONENTIAL") return Filter::exponential;
  value.fail(fmt::format("is '{}', must be NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL", name));
}

// The extension's rules for byteStride and count, which are also the codec's preconditions.
void check_layout(const MeshoptView& view) {
  const Value stride = view.at["byteStride"], filter = view.at["filter"];
  if (view.mode != Mode::attributes) {
    if (view.stride != 2 && view.stride != 4)
      stride.fail(fmt::format("is {}, must be 2 or 4 for indices", view.stride));
    if (view.filter != Filter::none) filter.fail("is for attributes only");
    if (view.mode == Mode::triangles && view.count % 3 != 0) {
      view.at["count"].fail(fmt::format("is {}, must be a multiple of 3", view.count));
    }
    return;
  }
  if (view.stride % 4 != 0) stride.fail(fmt::format("is {}, must be a multiple of 4", view.stride));
  if (view.filter == Filter::octahedral && view.stride != 4 && view.stride != 8) {
    stride.fail(fmt::format("is {}, must be 4 or 8 with the octahedral filter", view.stride));
  }
  if (view.filter == Filter::quaternion && view.stride != 8) {
    stride.fail(fmt::format("is {}, must be 8 with the quaternion filter", view.stride));
  }
}

// The fewest bytes that can hold the view: of attributes, 16 equal bytes of neighbours take 2 bits; a triangle takes a
// byte, as does an index of a sequence (the extension's specification, "Mode 0" to "Mode 2").
std::uint64_t fewest_bytes(const MeshoptView& view) {
  switch (view.mode) {
    case Mode::attributes:
      return view.count * view.stride / 64;
    case Mode::triangles:
      return view.count / 3;
    case Mode::indices:
      return view.count;
  }
  return 0;
}

// The codec's version is in the low half of the first byte; the packaged library reads 0 for attributes, 0 and 1 for
// indices.
void check_version(const MeshoptView& view, std::byte header) {
  const auto version = std::to_integer<unsigned>(header & std::byte{0x0f});
  if (version <= (view.mode == Mode::attributes ? 0u : 1u)) return;
  throw Error(ErrorCode::unsupported, view.at.file(),
              fmt::format("{}: the data is of version {} of the codec; compress it with an older one",
                          view.at.pointer(), version));
}

int decode_elements(const MeshoptView& view, std::span<const std::byte> compressed, std::vector<std::byte>& out) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(compressed.data());
  switch (view.mode) {
    case Mode::attributes:
      return meshopt_decodeVertexBuffer(out.data(), view.count, view.stride, bytes, compressed.size());
    case Mode::triangles:
      return meshopt_decodeIndexBuffer(out.data(), view.count, view.stride, bytes, compressed.size());
    case Mode::indices:
      return meshopt_decodeIndexSequence(out.data(), view.count, view.stride, bytes, compressed.size());
  }
  return -1;
}

void apply_filter(const MeshoptView& view, std::vector<std::byte>& elements) {
  switch (view.filter) {
    case Filter::none:
      return;
    case Filter::octahedral:
      return meshopt_decodeFilterOct(elements.data(), view.count, view.stride);
    case Filter::quaternion:
      return meshopt_decodeFilterQuat(elements.data(), view.count, view.stride);
    case Filter::exponential:
      return meshopt_decodeFilterExp(elements.data(), view.count, view.stride);
  }
}

}  // namespace

Value meshopt_extension(const Value& view) {
  return either_name(view["extensions"]);
}

bool is_meshopt_fallback(const Value& buffer) {
  return either_name(buffer["extensions"])["fallback"].boolean_or(false);
}

MeshoptView read_meshopt_view(const Value& extension, std::uint64_t length) {
  constexpr std::uint64_t kMaxStride = 256;  // the extension's limit
  MeshoptView view{.at = extension};
  view.mode = read_mode(extension.require("mode"));
  view.filter = read_filter(extension["filter"]);
  view.stride = static_cast<std::uint32_t>(extension.require("byteStride").integer(1, kMaxStride));
  const Value count = extension.require("count");
  view.count = count.integer(1, std::numeric_limits<std::uint32_t>::max());
  if (view.count * view.stride != length) {
    count.fail(
        fmt::format("{} elements of {} bytes do not fill the view of {} bytes", view.count, view.stride, length));
  }
  check_layout(view);
  return view;
}

std::vector<std::byte> decode_meshopt(const MeshoptView& view, std::span<const std::byte> compressed) {
  const std::uint64_t fewest = fewest_bytes(view);
  if (compressed.size() < fewest) {
    view.at.fail(
        fmt::format("{} bytes cannot hold {} elements, which take {} at least", compressed.size(), view.count, fewest));
  }
  check_version(view, compressed.front());
  std::vector<std::byte> elements(view.count * view.stride);
  if (decode_elements(view, compressed, elements) != 0) view.at.fail("the compressed data is damaged");
  apply_filter(view, elements);
  return elements;
}

}  // namespace velarium::scene::gltf
