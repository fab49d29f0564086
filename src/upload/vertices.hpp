#pragma once

#include "gpu/buffer.hpp"
#include "gpu/pipeline.hpp"
#include "scene/snapshot.hpp"

#include <array>
#include <vector>

namespace velarium::upload {

// Vertices are two streams: positions alone, for passes that need no more, and the rest, packed.
inline constexpr std::uint32_t kPositionStream = 0;
inline constexpr std::uint32_t kAttributeStream = 1;

struct PackedAttributes {               // 40 bytes
  std::array<std::int16_t, 4> normal;   // signed normalised; w unused
  std::array<std::int16_t, 4> tangent;  // signed normalised; w: sign of the bitangent
  std::array<float, 4> uv;              // set 0, set 1
  std::array<std::uint16_t, 4> color;   // half floats
};
static_assert(sizeof(PackedAttributes) == 40);

// How shaders see the streams: 0 position, 1 normal, 2 tangent, 3 uv, 4 colour.
[[nodiscard]] std::vector<gpu::VertexBinding> vertex_bindings();
[[nodiscard]] std::vector<gpu::VertexAttribute> vertex_attributes();

// Which of a primitive's texture coordinate sets become the vertex's two: those that its material reads.
struct UvChoice {
  std::array<std::uint32_t, 2> sets{0, 1};
  // 0 or 1: where set `uv_set` went. A set that found no place reads the first.
  [[nodiscard]] std::uint32_t place_of(std::uint32_t uv_set) const {
    return uv_set == sets[1] && uv_set != sets[0] ? 1 : 0;
  }
};

// `frames`: the primitive's own vertices, or a deformed version of them. `out` has room for each vertex.
void pack_attributes(const scene::Primitive& primitive, const scene::VertexFrames& frames, const UvChoice& uv,
                     std::span<PackedAttributes> out);

}  // namespace velarium::upload
