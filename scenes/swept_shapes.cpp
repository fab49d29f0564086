// The shapes of shapes.hpp that a function, a profile or a path makes.

#include "scenes/shapes.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::scene {
namespace {

constexpr float kSlopeStep = 1e-3f;        // of s and t, for slopes: a fifth of the finest grid that scenes use
constexpr float kLeastArea = 1e-9f;        // twice a triangle's area, m^2: 0.03 mm a side
constexpr float kSmoothCosine = 0.76604f;  // 40 degrees

// Beside a pole one slope vanishes on the pole itself: that of a point next to it serves.
glm::vec3 surface_normal(const SurfaceFunction& at, float s, float t) {
  for (const float inset : {0.0f, 4.0f * kSlopeStep}) {
    const float inner_t = t + (t < 0.5f ? inset : -inset);
    const glm::vec3 along_s = at(s + kSlopeStep, inner_t).position - at(s - kSlopeStep, inner_t).position;
    const glm::vec3 along_t = at(s, inner_t + kSlopeStep).position - at(s, inner_t - kSlopeStep).position;
    const glm::vec3 normal = glm::cross(along_s, along_t);
    if (glm::length(normal) > 1e-12f) return glm::normalize(normal);
  }
  return {0.0f, 1.0f, 0.0f};
}

void add_triangle(Primitive& p, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const auto& q = p.vertices.positions;
  if (glm::length(glm::cross(q[b] - q[a], q[c] - q[a])) > kLeastArea) p.indices.insert(p.indices.end(), {a, b, c});
}

// Two triangles to each cell of the last (columns + 1) x (rows + 1) vertices.
void add_cells(Primitive& p, std::uint32_t columns, std::uint32_t rows) {
  const auto first = static_cast<std::uint32_t>(p.vertex_count()) - (columns + 1) * (rows + 1);
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t a = first + row * (columns + 1) + column, b = a + columns + 1;
      add_triangle(p, a, a + 1, b + 1);
      add_triangle(p, a, b + 1, b);
    }
  }
}

void add_vertex(Primitive& p, const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv) {
  p.vertices.positions.push_back(position);
  p.vertices.normals.push_back(normal);
  p.uv[0].push_back(uv);
  p.bounds.add(position);
}

struct ProfileEdge {
  glm::vec2 from, to, normal_from, normal_to;
  float start, end;  // metres along the profile
};

std::vector<ProfileEdge> edges_of(const Profile& profile) {
  std::vector<ProfileEdge> edges;
  float way = 0.0f;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const glm::vec2 step = profile[i + 1] - profile[i];
    const glm::vec2 normal = glm::normalize(glm::vec2(step.y, -step.x));
    edges.push_back({profile[i], profile[i + 1], normal, normal, way, way + glm::length(step)});
    way = edges.back().end;
  }
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const glm::vec2 before = edges[i].normal_to, after = edges[i + 1].normal_from;
    if (glm::dot(before, after) < kSmoothCosine) continue;
    edges[i].normal_to = edges[i + 1].normal_from = glm::normalize(before + after);
  }
  return edges;
}

void add_turned_edge(Primitive& p, const ProfileEdge& edge, std::uint32_t segments, float around) {
  const auto add_ring = [&](const glm::vec2& place, const glm::vec2& normal, float way) {
    for (std::uint32_t i = 0; i <= segments; ++i) {
      const float part = static_cast<float>(i) / static_cast<float>(segments);
      const float x = std::sin(part * glm::two_pi<float>()), z = std::cos(part * glm::two_pi<float>());
      add_vertex(p, {place.x * x, place.y, place.x * z}, {normal.x * x, normal.y, normal.x * z}, {part * around, -way});
    }
  };
  add_ring(edge.from, edge.normal_from, edge.start);
  add_ring(edge.to, edge.normal_to, edge.end);
  add_cells(p, segments, 1);
}

}  // namespace

Primitive surface(std::uint32_t columns, std::uint32_t rows, const SurfaceFunction& at) {
  Primitive p;
  for (std::uint32_t row = 0; row <= rows; ++row) {
    for (std::uint32_t column = 0; column <= columns; ++column) {
      const float s = static_cast<float>(column) / static_cast<float>(columns);
      const float t = static_cast<float>(row) / static_cast<float>(rows);
      const SurfacePoint point = at(s, t);
      add_vertex(p, point.position, surface_normal(at, s, t), point.uv);
    }
  }
  add_cells(p, columns, rows);
  return p;
}

Primitive lathe(const Profile& profile, std::uint32_t segments, float around) {
  Primitive p;
  for (const ProfileEdge& edge : edges_of(profile)) add_turned_edge(p, edge, segments, around);
  return p;
}

Primitive straight_moulding(float half_length, const Profile& profile, float step, float mitre) {
  const auto cuts = static_cast<std::uint32_t>(std::max(1.0f, std::round(2.0f * half_length / step)));
  Primitive p;
  for (const ProfileEdge& edge : edges_of(profile)) {
    const auto add_row = [&](const glm::vec2& place, const glm::vec2& normal, float way) {
      for (std::uint32_t i = 0; i <= cuts; ++i) {
        const float part = 2.0f * static_cast<float>(i) / static_cast<float>(cuts) - 1.0f;
        const float run = part * (half_length + mitre * place.x);
        add_vertex(p, {run, place.y, place.x}, {0.0f, normal.y, normal.x}, {run, -way});
      }
    };
    add_row(edge.from, edge.normal_from, edge.start);
    add_row(edge.to, edge.normal_to, edge.end);
    add_cells(p, cuts, 1);
  }
  return p;
}

Primitive rectangle_moulding(const glm::vec2& half, const Profile& profile, float step) {
  const Primitive along_x = straight_moulding(half.x, profile, step, 1.0f);
  const Primitive along_z = straight_moulding(half.y, profile, step, 1.0f);
  Primitive p;
  for (int side = 0; side < 4; ++side) {
    const bool ends = side % 2 == 0;
    const glm::mat4 turn =
        glm::rotate(glm::mat4(1.0f), static_cast<float>(side) * glm::half_pi<float>(), glm::vec3(0, 1, 0));
    append(p, ends ? along_x : along_z, glm::translate(turn, glm::vec3(0, 0, ends ? half.y : half.x)));
  }
  return p;
}

Primitive tube(std::span<const glm::vec3> path, float radius, std::uint32_t segments) {
  Primitive p;
  glm::vec3 side(0.0f);
  float way = 0.0f;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const glm::vec3 ahead = path[std::min(i + 1, path.size() - 1)] - path[i == 0 ? 0 : i - 1];
    const glm::vec3 forward = glm::normalize(ahead);
    // The frame is carried along, so that the bar does not twist.
    const glm::vec3 start = std::abs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 guide = i == 0 ? start : side;
    side = glm::normalize(guide - glm::dot(guide, forward) * forward);
    const glm::vec3 other = glm::cross(forward, side);
    if (i > 0) way += glm::length(path[i] - path[i - 1]);
    for (std::uint32_t k = 0; k <= segments; ++k) {
      const float part = static_cast<float>(k) / static_cast<float>(segments);
      const glm::vec3 n = std::cos(part * glm::two_pi<float>()) * side + std::sin(part * glm::two_pi<float>()) * other;
      add_vertex(p, path[i] + radius * n, n, {part * glm::two_pi<float>() * radius, way});
    }
  }
  add_cells(p, segments, static_cast<std::uint32_t>(path.size()) - 1);
  return p;
}

Primitive box(const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 size = high - low;
  Primitive p;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      const int s = (axis + 1) % 3, t = (axis + 2) % 3;
      const int first = upper ? s : t, second = upper ? t : s;
      const int upright = first == 1 ? first : second;  // which of the two the texture's v follows
      append(p, surface(1, 1, [&](float a, float b) {
               glm::vec3 q = low;
               q[axis] = upper ? high[axis] : low[axis];
               q[first] += a * size[first];
               q[second] += b * size[second];
               return SurfacePoint{q, {q[upright == first ? second : first], -q[upright]}};
             }));
    }
  }
  return p;
}

void append(Primitive& whole, const Primitive& part, const glm::mat4& transform) {
  const auto first = static_cast<std::uint32_t>(whole.vertex_count());
  const glm::mat3 normals = glm::inverseTranspose(glm::mat3(transform));
  for (std::size_t i = 0; i < part.vertex_count(); ++i) {
    add_vertex(whole, glm::vec3(transform * glm::vec4(part.vertices.positions[i], 1.0f)),
               glm::normalize(normals * part.vertices.normals[i]), part.uv[0][i]);
  }
  for (const std::uint32_t index : part.indices) whole.indices.push_back(first + index);
}

}  // namespace velarium::scene
