#pragma once

// EXT_meshopt_compression: buffer views whose bytes lie compressed in another buffer.

#include "scene/gltf_json.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace velarium::scene::gltf {

// The extension's object in a buffer view, under either of its names; absent where there is none.
// KHR_meshopt_compression has the same layout; of what it adds, nothing is read.
[[nodiscard]] Value meshopt_extension(const Value& view);
// Whether a buffer only holds place for views that are compressed, and so needs no data.
[[nodiscard]] bool is_meshopt_fallback(const Value& buffer);

// What the object says, checked against the extension's rules.
struct MeshoptView {
  enum class Mode : std::uint8_t { attributes, triangles, indices };
  enum class Filter : std::uint8_t { none, octahedral, quaternion, exponential };
  Value at;
  Mode mode = Mode::attributes;
  Filter filter = Filter::none;
  std::uint32_t stride = 0;  // bytes an element
  std::uint64_t count = 0;   // elements
};

// Throws where the object breaks a rule, or where it does not fill the `length` bytes of its view.
[[nodiscard]] MeshoptView read_meshopt_view(const Value& extension, std::uint64_t length);

// count * stride bytes. Throws, before it asks for memory, where `compressed` is too short to hold so much, and
// where it is damaged; Error(unsupported) where it is of a later version of the codec.
[[nodiscard]] std::vector<std::byte> decode_meshopt(const MeshoptView& view, std::span<const std::byte> compressed);

}  // namespace velarium::scene::gltf
