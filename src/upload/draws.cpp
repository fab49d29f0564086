#include "upload/draws.hpp"

#include "upload/materials.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <tuple>

namespace velarium::upload {
namespace {

struct Candidate {
  const scene::Instance* instance;
  std::uint32_t material;
  double distance2;  // of the bounds' centre from the eye, square metres
  bool joins;        // may it share a draw with a neighbour of the same state?
  auto state() const { return std::tuple(instance->primitive, instance->deformed, material, instance->mirrored); }
};

// Appends a draw for each run of candidates that share their state.
void add_draws(const std::vector<Candidate>& candidates, const glm::dvec3& eye, std::vector<ObjectData>& objects,
               std::vector<Draw>& draws) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto& c = candidates[i];
    objects.push_back(object_data(*c.instance, eye));
    if (c.joins && i > 0 && candidates[i - 1].state() == c.state()) {
      ++draws.back().object_count;
      continue;
    }
    draws.push_back({c.instance->primitive, c.instance->deformed, c.material,
                     static_cast<std::uint32_t>(objects.size() - 1), 1, c.instance->mirrored});
  }
}

// Near to far overall, so that hidden surfaces are not shaded, but all instances of one state beside each other:
// a state stands where its nearest instance does.
void sort_opaque(std::vector<Candidate>& candidates) {
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(a.state(), a.distance2) < std::tuple(b.state(), b.distance2);
  });
  std::vector<double> nearest(candidates.size());
  for (std::size_t i = 0; i < candidates.size(); ++i)
    nearest[i] = i > 0 && candidates[i - 1].state() == candidates[i].state() ? nearest[i - 1] : candidates[i].distance2;
  std::vector<std::size_t> order(candidates.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return nearest[a] < nearest[b]; });
  std::vector<Candidate> sorted;
  for (const std::size_t i : order) sorted.push_back(candidates[i]);
  candidates = std::move(sorted);
}

}  // namespace

Frustum frustum_of(const glm::dmat4& clip_from_world) {
  const glm::dmat4 rows = glm::transpose(clip_from_world);
  // Reversed-Z: the near plane is at depth 1, and an infinite far plane never refuses anything.
  return {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1], rows[3] - rows[2]};
}

ObjectData object_data(const scene::Instance& instance, const glm::dvec3& eye) {
  const glm::mat4& m = instance.world_from_object;
  ObjectData data{};
  for (int row = 0; row < 3; ++row) {
    const auto translation = static_cast<float>(static_cast<double>(m[3][row]) - eye[row]);
    data.world_from_object[row] = {m[0][row], m[1][row], m[2][row], translation};
  }
  return data;
}

bool overlaps(std::span<const glm::dvec4> planes, const scene::Aabb& box) {
  for (const auto& plane : planes) {
    const glm::dvec3 farthest(plane.x > 0 ? box.max.x : box.min.x, plane.y > 0 ? box.max.y : box.min.y,
                              plane.z > 0 ? box.max.z : box.min.z);
    if (glm::dot(glm::dvec3(plane), farthest) + plane.w < 0.0) return false;
  }
  return true;
}

DrawList make_draw_list(const scene::Scene& scene, const scene::Moment& moment, const Frustum& frustum,
                        const glm::dvec3& eye) {
  std::vector<Candidate> opaque, blended;
  for (const auto& instance : moment.instances) {
    if (instance.bounds.empty() || !overlaps(frustum, instance.bounds)) continue;
    const std::int32_t material = scene.primitives[instance.primitive].material;
    const glm::dvec3 center = 0.5 * (glm::dvec3(instance.bounds.min) + glm::dvec3(instance.bounds.max)) - eye;
    const auto& surface = material_or_default(scene, material);
    const bool blend = surface.alpha_mode == scene::AlphaMode::blend;
    // Double-sided blended surfaces are drawn one by one: far side, then near side.
    (blend ? blended : opaque)
        .push_back(
            {&instance, material_index(scene, material), glm::dot(center, center), !(blend && surface.double_sided)});
  }
  sort_opaque(opaque);
  std::stable_sort(blended.begin(), blended.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance2 > b.distance2; });
  DrawList list;
  add_draws(opaque, eye, list.objects, list.opaque);
  add_draws(blended, eye, list.objects, list.blended);
  return list;
}

}  // namespace velarium::upload
