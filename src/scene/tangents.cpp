#include "scene/tangents.hpp"

#include "core/assert.hpp"
#include "scene/mikktspace.hpp"
#include "scene/tangents_split.hpp"

namespace velarium::scene {
namespace {

// Corner -> the first corner of the same vertex with the same tangent.
std::vector<std::uint32_t> agreeing_corners(const std::vector<std::uint32_t>& indices,
                                            const std::vector<glm::vec4>& tangents) {
  const auto hash = [&](std::uint32_t corner) { return WordHash().add(indices[corner]).add(tangents[corner]).value(); };
  const auto equal = [&](std::uint32_t a, std::uint32_t b) {
    return indices[a] == indices[b] && same_words(tangents[a], tangents[b]);
  };
  return first_equals(indices.size(), hash, equal);
}

}  // namespace

void make_tangents(Primitive& primitive, std::uint32_t uv_set) {
  VEL_ASSERT(primitive.topology == Topology::triangles && uv_set < kMaxUvSets);
  VEL_ASSERT(primitive.vertices.normals.size() == primitive.vertex_count());
  VEL_ASSERT(primitive.uv[uv_set].size() == primitive.vertex_count());
  const std::vector<glm::vec4> tangents = corner_tangents(
      {primitive.vertices.positions, primitive.vertices.normals, primitive.uv[uv_set], primitive.indices});

  const std::vector<std::uint32_t> first = agreeing_corners(primitive.indices, tangents);
  std::vector<std::uint32_t> sources, new_indices(primitive.indices.size());
  std::vector<glm::vec4> new_tangents;
  for (std::uint32_t corner = 0; corner < first.size(); ++corner) {
    if (first[corner] != corner) {
      new_indices[corner] = new_indices[first[corner]];
      continue;
    }
    new_indices[corner] = static_cast<std::uint32_t>(sources.size());
    sources.push_back(primitive.indices[corner]);
    new_tangents.push_back(tangents[corner]);
  }
  primitive.vertices.tangents.clear();
  gather_vertices(primitive, sources);
  primitive.indices = std::move(new_indices);
  primitive.vertices.tangents = std::move(new_tangents);
}

}  // namespace velarium::scene
