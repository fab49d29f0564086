#include "scene/tangents_split.hpp"

namespace velarium::scene {
namespace {

// `sets`: how many blocks of `count` vertices the attribute holds, one after the other.
template <class T>
void gather(std::vector<T>& values, std::span<const std::uint32_t> sources, std::size_t count, std::size_t sets = 1) {
  if (values.empty()) return;
  std::vector<T> out;
  out.reserve(sets * sources.size());
  for (std::size_t set = 0; set < sets; ++set) {
    for (const std::uint32_t source : sources) out.push_back(values[set * count + source]);
  }
  values = std::move(out);
}

}  // namespace

void gather_vertices(Primitive& primitive, std::span<const std::uint32_t> sources) {
  const std::size_t count = primitive.vertex_count();
  gather(primitive.vertices.positions, sources, count);
  gather(primitive.vertices.normals, sources, count);
  gather(primitive.vertices.tangents, sources, count);
  for (auto& uv : primitive.uv) gather(uv, sources, count);
  gather(primitive.colors, sources, count);
  gather(primitive.joints, sources, count, primitive.skin_sets);
  gather(primitive.weights, sources, count, primitive.skin_sets);
  for (MorphTarget& target : primitive.morph_targets) {
    gather(target.positions, sources, count);
    gather(target.normals, sources, count);
    gather(target.tangents, sources, count);
  }
}

}  // namespace velarium::scene
