#include "passes/local_shadows/screen_coverage.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::local_shadows {
namespace {

using glm::dvec2, glm::dvec3, glm::dvec4;

// A view begins a little before the eye, where perspective has no end. As a share of how far it reaches.
constexpr double kNearShare = 1e-6;

// The plane through a point at right angles to `normal` (of any length) that has `inside` on its inner side. Flat
// solids have sides without area: such a plane has all points inside.
dvec4 plane_at(const dvec3& point, dvec3 normal, const dvec3& inside) {
  const double length = glm::length(normal);
  if (length > 0.0) normal /= length;
  if (glm::dot(normal, inside - point) < 0.0) normal = -normal;
  return {normal, -glm::dot(normal, point)};
}

// Of corners as a box has them: bit 0 of the index tells left from right, bit 1 lower from upper, bit 2 near from far.
Solid hexahedron(const std::array<dvec3, 8>& corners) {
  constexpr std::array<std::array<std::size_t, 4>, 6> kSides{
      {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};
  dvec3 middle(0.0);
  for (const auto& corner : corners) middle += corner / 8.0;
  Solid solid;
  for (const auto& [a, b, c, d] : kSides)
    solid.push_back({plane_at(corners[a], glm::cross(corners[c] - corners[a], corners[d] - corners[b]), middle),
                     {corners[a], corners[b], corners[c], corners[d]}});
  return solid;
}

// A convex polygon that planes cut corners off: each adds one corner at most.
class Polygon {
 public:
  explicit Polygon(const std::array<dvec3, 4>& corners) : count_(corners[3] == corners[2] ? 3 : 4) {
    std::copy(corners.begin(), corners.end(), corners_.begin());
  }

  // Keeps what is inside [Sutherland & Hodgman 1974].
  void clip(const dvec4& plane) {
    std::array<dvec3, kMost> kept;
    std::size_t count = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const dvec3 &a = corners_[i], &b = corners_[i + 1 < count_ ? i + 1 : 0];
      const double at_a = glm::dot(dvec3(plane), a) + plane.w, at_b = glm::dot(dvec3(plane), b) + plane.w;
      if (at_a >= 0.0 && count < kMost) kept[count++] = a;
      if ((at_a >= 0.0) != (at_b >= 0.0) && count < kMost) kept[count++] = a + (b - a) * (at_a / (at_a - at_b));
    }
    corners_ = kept;
    count_ = count;
  }

  [[nodiscard]] std::span<const dvec3> corners() const { return {corners_.data(), count_}; }

 private:
  static constexpr std::size_t kMost = 24;  // 4, and one for each of up to 17 planes
  std::array<dvec3, kMost> corners_{};
  std::size_t count_;
};

// Twice the area of the triangle, positive where c is to the left of the way from a to b.
double turn(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Area of the smallest convex polygon around the points [Andrew's monotone chain, 1979].
double hull_area(std::vector<dvec2>& points) {
  std::sort(points.begin(), points.end(),
            [](const dvec2& a, const dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  double area = 0.0;
  const auto add_chain = [&](auto begin, auto end) {
    std::vector<dvec2> chain;
    for (auto point = begin; point != end; ++point) {
      while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), *point) <= 0.0) chain.pop_back();
      chain.push_back(*point);
    }
    for (std::size_t i = 1; i < chain.size(); ++i)
      area += 0.5 * (chain[i - 1].x * chain[i].y - chain[i - 1].y * chain[i].x);
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return area;
}

}  // namespace

Solid view_solid(const upload::ViewMatrices& view, const dvec3& eye, double far) {
  const glm::dmat4 projection(view.clip_from_view);
  const bool perspective = projection[3][3] == 0.0;
  const glm::dmat3 world_from_view = glm::transpose(glm::dmat3(view.view_from_world));
  std::array<dvec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec2 ndc((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0);
    const double depth = (i & 4) != 0 ? far : (perspective ? kNearShare * far : 0.0);
    dvec2 place;
    for (int axis = 0; axis < 2; ++axis)
      place[axis] = perspective ? depth * (ndc[axis] + projection[2][axis]) / projection[axis][axis]
                                : (ndc[axis] - projection[3][axis]) / projection[axis][axis];
    corners[i] = world_from_view * dvec3(place, -depth) + eye;
  }
  return hexahedron(corners);
}

Solid box_solid(const dvec3& low, const dvec3& high) {
  std::array<dvec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {(i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z};
  return hexahedron(corners);
}

Solid pyramid_solid(const dvec3& apex, const std::array<dvec3, 3>& axes, double half_tangent, double reach) {
  const double half = half_tangent * reach;
  const dvec3 middle = apex + reach * axes[2];
  const std::array<dvec3, 4> rim{middle - half * axes[0] - half * axes[1], middle + half * axes[0] - half * axes[1],
                                 middle + half * axes[0] + half * axes[1], middle - half * axes[0] + half * axes[1]};
  const dvec3 inside = apex + 0.5 * reach * axes[2];
  Solid solid{{plane_at(middle, axes[2], inside), rim}};
  for (std::size_t i = 0; i < 4; ++i) {
    const dvec3 &a = rim[i], &b = rim[(i + 1) % 4];
    solid.push_back({plane_at(apex, glm::cross(a - apex, b - apex), inside), {apex, a, b, b}});
  }
  return solid;
}

double covered_share(std::span<const Solid* const> solids, const glm::dmat4& clip_from_world) {
  std::vector<dvec2> seen;
  for (const Solid* solid : solids) {
    for (const Side& side : *solid) {
      Polygon polygon(side.corners);
      for (const Solid* other : solids)
        if (other != solid)
          for (const Side& cut : *other) polygon.clip(cut.plane);
      for (const dvec3& corner : polygon.corners()) {
        const dvec4 clip = clip_from_world * dvec4(corner, 1.0);
        if (clip.w > 0.0)
          seen.emplace_back(std::clamp(clip.x / clip.w, -1.0, 1.0), std::clamp(clip.y / clip.w, -1.0, 1.0));
      }
    }
  }
  // The whole picture is a square of 2 by 2.
  return seen.empty() ? 0.0 : std::clamp(hull_area(seen) / 4.0, 0.0, 1.0);
}

}  // namespace velarium::local_shadows
