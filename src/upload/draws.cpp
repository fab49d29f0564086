#include "upload/draws.hpp"

#include "core/jobs.hpp"
#include "upload/materials.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <tuple>

namespace velarium::upload {
namespace {

struct Candidate {
  const scene::Instance* instance;
  std::uint32_t material;
  double farness;                            // of the bounds' centre: Viewpoint
  bool joins;                                // may it share a draw with a neighbour of the same state?
  std::int32_t first_sorted = scene::kNone;  // Draw's
  auto state() const {
    return std::tuple(instance->primitive, instance->deformed, material, instance->mirrored, first_sorted);
  }
};

// Appends a draw for each run of candidates that share their state.
void add_draws(const std::vector<Candidate>& candidates, const glm::dvec3& origin, std::vector<ObjectData>& objects,
               std::vector<Draw>& draws) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto& c = candidates[i];
    objects.push_back(object_data(*c.instance, origin));
    if (c.joins && i > 0 && candidates[i - 1].state() == c.state()) {
      ++draws.back().object_count;
      continue;
    }
    draws.push_back({c.instance->primitive, c.instance->deformed, c.material,
                     static_cast<std::uint32_t>(objects.size() - 1), 1, c.instance->mirrored, c.first_sorted});
  }
}

// Gives the nearest objects room in the sorted indices, as far as the budget goes, and returns how many indices they
// have. A single quad has no order worth finding, and many of them may be one draw.
std::size_t choose_sorted(const scene::Scene& scene, std::vector<Candidate>& blended, std::size_t triangle_budget) {
  constexpr std::size_t kQuad = 6;
  std::size_t used = 0;
  for (auto candidate = blended.rbegin(); candidate != blended.rend(); ++candidate) {
    const auto& primitive = scene.primitives[candidate->instance->primitive];
    const std::size_t count = primitive.indices.size();
    if (primitive.topology != scene::Topology::triangles || count <= kQuad || used + count > 3 * triangle_budget)
      continue;
    candidate->first_sorted = static_cast<std::int32_t>(used);
    used += count;
  }
  return used;
}

std::vector<std::uint32_t> sort_triangles(const scene::Scene& scene, const scene::SceneSnapshot& snapshot,
                                          const Viewpoint& view, const std::vector<Candidate>& blended,
                                          std::size_t index_count) {
  std::vector<std::uint32_t> all(index_count);
  parallel_for(blended.size(), [&](std::size_t i) {
    if (blended[i].first_sorted == scene::kNone) return;
    const auto& instance = *blended[i].instance;
    const auto& primitive = scene.primitives[instance.primitive];
    const auto sorted = far_to_near(primitive.indices, scene::positions_of(scene, snapshot, instance),
                                    instance.world_from_object, view);
    std::copy(sorted.begin(), sorted.end(), all.begin() + blended[i].first_sorted);
  });
  return all;
}

// Near to far overall, so that hidden surfaces are not shaded, but all instances of one state beside each other:
// a state stands where its nearest instance does.
void sort_opaque(std::vector<Candidate>& candidates) {
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(a.state(), a.farness) < std::tuple(b.state(), b.farness);
  });
  std::vector<double> nearest(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i)
    nearest[i] = i > 0 && candidates[i - 1].state() == candidates[i].state() ? nearest[i - 1] : candidates[i].farness;
  std::vector<std::size_t> order(candidates.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return nearest[a] < nearest[b]; });
  std::vector<Candidate> sorted;
  sorted.reserve(order.size());
  for (const std::size_t i : order) sorted.push_back(candidates[i]);
  candidates = std::move(sorted);
}

}  // namespace

Frustum frustum_of(const glm::dmat4& clip_from_world) {
  const glm::dmat4 rows = glm::transpose(clip_from_world);
  // Reversed-Z: the near plane is at depth 1, and an infinite far plane never refuses anything.
  return {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1], rows[3] - rows[2]};
}

ObjectData object_data(const scene::Instance& instance, const glm::dvec3& origin) {
  glm::dmat4 m = instance.world_from_object;
  m[3] -= glm::dvec4(origin, 0.0);
  const glm::mat4 rows(glm::transpose(m));
  ObjectData data{};
  for (int row = 0; row < 3; ++row) data.world_from_object[row] = rows[row];
  return data;
}

bool overlaps(std::span<const glm::dvec4> planes, const scene::WorldAabb& box) {
  for (const auto& plane : planes) {
    const glm::dvec3 farthest(plane.x > 0 ? box.max.x : box.min.x, plane.y > 0 ? box.max.y : box.min.y,
                              plane.z > 0 ? box.max.z : box.min.z);
    if (glm::dot(glm::dvec3(plane), farthest) + plane.w < 0.0) return false;
  }
  return true;
}

DrawList make_draw_list(const scene::Scene& scene, const scene::SceneSnapshot& snapshot, const glm::dvec3& origin,
                        const Frustum& frustum, const Viewpoint& view, std::size_t sorted_triangles) {
  std::vector<Candidate> opaque, blended;
  for (const auto& instance : snapshot.instances) {
    if (instance.bounds.empty() || !overlaps(frustum, instance.bounds)) continue;
    const std::int32_t material = scene.primitives[instance.primitive].material;
    const glm::dvec3 center = 0.5 * (instance.bounds.min + instance.bounds.max) - view.eye;
    const auto& surface = material_or_default(scene, material);
    const bool blend = surface.alpha_mode == scene::AlphaMode::blend;
    // Of double-sided blended surfaces that are not sorted, each is drawn by itself: far side, then near side.
    (blend ? blended : opaque)
        .push_back(
            {&instance, material_index(scene, material), view.farness(center), !(blend && surface.double_sided)});
  }
  sort_opaque(opaque);
  std::stable_sort(blended.begin(), blended.end(),
                   [](const Candidate& a, const Candidate& b) { return a.farness > b.farness; });
  DrawList list;
  const std::size_t sorted_count = choose_sorted(scene, blended, sorted_triangles);
  list.sorted_indices = sort_triangles(scene, snapshot, view, blended, sorted_count);
  add_draws(opaque, origin, list.objects, list.opaque);
  add_draws(blended, origin, list.objects, list.blended);
  return list;
}

}  // namespace velarium::upload
