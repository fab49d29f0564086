// Tangent frames a corner. The steps, each a function below, in the order of corner_tangents() at the end:
//   1. weld vertices that agree in position, normal and uv;
//   2. set aside triangles with two corners in one place;
//   3. give each face its directions of increasing u and v, and say whether its uv map keeps the orientation;
//   4. pair faces across edges that they walk in opposite directions;
//   5. around each vertex, flood over paired faces of equal orientation: a group;
//   6. average the directions of a group, weighted by corner angle, in the plane of the normal;
//   7. lend the triangles set aside what a good corner of the same vertex got.
// Arithmetic is single precision and sums run in face order, as in the reference implementation, so that normal maps
// baked against it decode to the same last bits.

#include "scene/mikktspace.hpp"

#include "scene/tangents_split.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <cfloat>
#include <cmath>
#include <deque>

namespace velarium::scene {
namespace {

constexpr std::uint32_t kNoneYet = 0xffffffffu;

struct Face {
  std::array<std::uint32_t, 3> vertex{};                                 // welded
  std::array<std::uint32_t, 3> neighbour{kNoneYet, kNoneYet, kNoneYet};  // across the edge from corner k to k + 1
  std::array<std::uint32_t, 3> group{kNoneYet, kNoneYet, kNoneYet};      // of each corner
  glm::vec3 along_u{0.0f}, along_v{0.0f};  // unit, in the face's plane; zero where it has no area in uv
  std::uint32_t triangle = 0;              // number in the input
  bool keeps_orientation = false;
  bool joins_any = true;  // no usable uv map: takes the orientation of the first group that reaches it
};

struct Group {
  std::uint32_t vertex = 0;
  bool keeps_orientation = false;
  std::size_t begin = 0, end = 0;  // into Groups::members
};

struct Groups {
  std::vector<Group> list;
  std::vector<std::uint32_t> members;  // faces, group after group
};

// The reference's test for "is not zero".
bool not_zero(float x) {
  return std::abs(x) > FLT_MIN;
}

glm::vec3 normalized_or_zero(const glm::vec3& v) {
  if (!not_zero(v.x) && !not_zero(v.y) && !not_zero(v.z)) return v;
  return v * (1.0f / std::sqrt(glm::dot(v, v)));
}

glm::vec3 in_plane(const glm::vec3& v, const glm::vec3& normal) {
  return normalized_or_zero(v - normal * glm::dot(normal, v));
}

std::uint32_t corner_of(const Face& face, std::uint32_t vertex) {
  return face.vertex[0] == vertex ? 0 : face.vertex[1] == vertex ? 1 : 2;
}

std::vector<std::uint32_t> weld(const TangentInput& mesh) {
  const auto hash = [&](std::uint32_t i) {
    return WordHash().add(mesh.positions[i]).add(mesh.normals[i]).add(mesh.uv[i]).value();
  };
  const auto equal = [&](std::uint32_t a, std::uint32_t b) {
    return same_words(mesh.positions[a], mesh.positions[b]) && same_words(mesh.normals[a], mesh.normals[b]) &&
           same_words(mesh.uv[a], mesh.uv[b]);
  };
  return first_equals(mesh.positions.size(), hash, equal);
}

// Step 3: the derivatives of position by u and v, from two edges in both spaces.
void orient(Face& face, const TangentInput& mesh) {
  const auto [a, b, c] = face.vertex;
  const glm::vec3 edge1 = mesh.positions[b] - mesh.positions[a], edge2 = mesh.positions[c] - mesh.positions[a];
  const glm::vec2 uv1 = mesh.uv[b] - mesh.uv[a], uv2 = mesh.uv[c] - mesh.uv[a];
  const float signed_area = uv1.x * uv2.y - uv1.y * uv2.x;
  face.keeps_orientation = signed_area > 0.0f;
  if (!not_zero(signed_area)) return;
  const float sign = face.keeps_orientation ? 1.0f : -1.0f;
  const glm::vec3 along_u = uv2.y * edge1 - uv1.y * edge2;
  const glm::vec3 along_v = -uv2.x * edge1 + uv1.x * edge2;
  const float length_u = glm::length(along_u), length_v = glm::length(along_v);
  if (not_zero(length_u)) face.along_u = (sign / length_u) * along_u;
  if (not_zero(length_v)) face.along_v = (sign / length_v) * along_v;
  const float area = std::abs(signed_area);
  face.joins_any = !not_zero(length_u / area) || !not_zero(length_v / area);
}

// Steps 2 and 3: the triangles whose corners are in three places.
std::vector<Face> make_faces(const TangentInput& mesh, const std::vector<std::uint32_t>& welded) {
  std::vector<Face> faces;
  faces.reserve(mesh.indices.size() / 3);
  for (std::uint32_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    Face face;
    for (std::uint32_t k = 0; k < 3; ++k) face.vertex[k] = welded[mesh.indices[i + k]];
    const glm::vec3 &a = mesh.positions[face.vertex[0]], &b = mesh.positions[face.vertex[1]],
                    &c = mesh.positions[face.vertex[2]];
    if (a == b || b == c || c == a) continue;
    face.triangle = i / 3;
    orient(face, mesh);
    faces.push_back(face);
  }
  return faces;
}

struct Edge {
  std::uint32_t low, high;  // welded vertices
  std::uint32_t face, side;
  bool forward;  // from low to high
  [[nodiscard]] bool joins_same(const Edge& other) const { return low == other.low && high == other.high; }
};

// Step 4. Where more than two faces meet in an edge, the earliest that waits is paired with the next that runs the
// other way, as the reference does.
void pair_faces(std::vector<Face>& faces) {
  std::vector<Edge> edges;
  edges.reserve(3 * faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t from = faces[f].vertex[k], to = faces[f].vertex[(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), f, k, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.face < b.face;
  });
  std::deque<const Edge*> waiting;  // of one edge, all in one direction
  for (const Edge& edge : edges) {
    if (!waiting.empty() && !waiting.front()->joins_same(edge)) waiting.clear();
    if (waiting.empty() || waiting.front()->forward == edge.forward) {
      waiting.push_back(&edge);
      continue;
    }
    const Edge& mate = *waiting.front();
    faces[edge.face].neighbour[edge.side] = mate.face;
    faces[mate.face].neighbour[mate.side] = edge.face;
    waiting.pop_front();
  }
}

// Whether `face` now belongs to the group and did not before.
bool joins(Face& face, const Group& group, std::uint32_t group_number) {
  std::uint32_t& mine = face.group[corner_of(face, group.vertex)];
  if (mine != kNoneYet) return false;
  const bool untouched = face.group[0] == kNoneYet && face.group[1] == kNoneYet && face.group[2] == kNoneYet;
  if (face.joins_any && untouched) face.keeps_orientation = group.keeps_orientation;
  if (face.keeps_orientation != group.keeps_orientation) return false;
  mine = group_number;
  return true;
}

// Step 5.
Groups group_corners(std::vector<Face>& faces) {
  Groups groups;
  groups.members.reserve(3 * faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (faces[f].joins_any || faces[f].group[k] != kNoneYet) continue;
      const auto number = static_cast<std::uint32_t>(groups.list.size());
      Group group{faces[f].vertex[k], faces[f].keeps_orientation, groups.members.size(), 0};
      faces[f].group[k] = number;
      groups.members.push_back(f);
      for (std::size_t next = group.begin; next < groups.members.size(); ++next) {
        const Face& face = faces[groups.members[next]];
        const std::uint32_t corner = corner_of(face, group.vertex);
        for (const std::uint32_t side : {corner, (corner + 2) % 3}) {
          const std::uint32_t neighbour = face.neighbour[side];
          if (neighbour != kNoneYet && joins(faces[neighbour], group, number)) groups.members.push_back(neighbour);
        }
      }
      group.end = groups.members.size();
      std::sort(groups.members.begin() + static_cast<std::ptrdiff_t>(group.begin), groups.members.end());
      groups.list.push_back(group);
    }
  }
  return groups;
}

// What one face brings to the average of its group.
struct Share {
  std::uint32_t face = 0, corner = 0;
  glm::vec3 along_u{0.0f}, along_v{0.0f};  // unit, in the plane of the vertex normal
  float angle = 0.0f;                      // of the corner, seen along the normal; 0 where the face has no uv map
  bool joins_any = false;
};

Share share_of(const std::vector<Face>& faces, std::uint32_t number, std::uint32_t vertex, const TangentInput& mesh) {
  const Face& face = faces[number];
  const glm::vec3& normal = mesh.normals[vertex];
  Share share{number, corner_of(face, vertex), in_plane(face.along_u, normal), in_plane(face.along_v, normal),
              0.0f,   face.joins_any};
  if (face.joins_any) return share;
  const glm::vec3& here = mesh.positions[vertex];
  const glm::vec3 to_last = in_plane(mesh.positions[face.vertex[(share.corner + 2) % 3]] - here, normal);
  const glm::vec3 to_next = in_plane(mesh.positions[face.vertex[(share.corner + 1) % 3]] - here, normal);
  share.angle = static_cast<float>(std::acos(static_cast<double>(std::clamp(glm::dot(to_last, to_next), -1.0f, 1.0f))));
  return share;
}

// With a threshold of 180 degrees only exactly opposite directions part (the reference compares cosines with
// "greater than -1").
bool averages_with(const Share& a, const Share& b) {
  if (a.joins_any || b.joins_any || a.face == b.face) return true;
  return glm::dot(a.along_u, b.along_u) > -1.0f && glm::dot(a.along_v, b.along_v) > -1.0f;
}

// Whether no two directions can be opposite: all lie well inside one half of the plane.
bool lies_in_one_half(std::span<const Share> shares) {
  constexpr float kWellInside = 0.01f;  // far above the rounding of a cosine
  const Share* first = nullptr;
  for (const Share& share : shares) {
    if (share.joins_any) continue;
    if (first == nullptr) first = &share;
    if (glm::dot(first->along_u, share.along_u) < kWellInside) return false;
    if (glm::dot(first->along_v, share.along_v) < kWellInside) return false;
  }
  return true;
}

// Some unit vector in the plane of a normal, for corners whose uv coordinates name no direction.
glm::vec3 any_tangent(const glm::vec3& normal) {
  const glm::vec3 axis = std::abs(normal.x) < 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
  return in_plane(axis, normal);
}

glm::vec3 unit_or_any(const glm::vec3& sum, const glm::vec3& normal) {
  const glm::vec3 unit = normalized_or_zero(sum);
  const float square = glm::dot(unit, unit);
  return square > 0.5f && square < 2.0f ? unit : any_tangent(normal);
}

class Averager {
 public:
  Averager(const TangentInput& mesh, const std::vector<Face>& faces) : mesh_(mesh), faces_(faces) {
    tangents_.resize(mesh.indices.size(), glm::vec4(0.0f));
  }

  // Step 6.
  void add(const Group& group, std::span<const std::uint32_t> members) {
    shares_.clear();
    for (const std::uint32_t face : members) shares_.push_back(share_of(faces_, face, group.vertex, mesh_));
    // Comparing all pairs takes quadratic time. A fan of so many faces that point everywhere has no meaningful
    // average, and a hostile file must not stop the reader.
    constexpr std::size_t kMostPairwise = 256;
    if (shares_.size() > kMostPairwise || lies_in_one_half(shares_)) {
      glm::vec3 sum(0.0f);
      for (const Share& share : shares_) sum += share.angle * share.along_u;
      for (const Share& share : shares_) store(share, group, sum);
      return;
    }
    for (const Share& mine : shares_) {
      glm::vec3 sum(0.0f);
      for (const Share& other : shares_) {
        if (averages_with(mine, other)) sum += other.angle * other.along_u;
      }
      store(mine, group, sum);
    }
  }

  // Step 7. Corners that still have none take that of the first good corner of the same vertex, or any.
  std::vector<glm::vec4> finish(const std::vector<std::uint32_t>& welded) && {
    std::vector<std::uint32_t> good_corner(mesh_.positions.size(), kNoneYet);
    for (const Face& face : faces_) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        std::uint32_t& first = good_corner[face.vertex[k]];
        const std::uint32_t corner = 3 * face.triangle + k;
        if (first == kNoneYet && tangents_[corner].w != 0.0f) first = corner;
      }
    }
    for (std::uint32_t corner = 0; corner < tangents_.size(); ++corner) {
      if (tangents_[corner].w != 0.0f) continue;
      const std::uint32_t vertex = welded[mesh_.indices[corner]];
      const std::uint32_t good = good_corner[vertex];
      tangents_[corner] = good != kNoneYet ? tangents_[good] : glm::vec4(any_tangent(mesh_.normals[vertex]), 1.0f);
    }
    return std::move(tangents_);
  }

 private:
  void store(const Share& share, const Group& group, const glm::vec3& sum) {
    const glm::vec3 tangent = unit_or_any(sum, mesh_.normals[group.vertex]);
    tangents_[3 * faces_[share.face].triangle + share.corner] =
        glm::vec4(tangent, group.keeps_orientation ? -1.0f : 1.0f);
  }

  const TangentInput& mesh_;
  const std::vector<Face>& faces_;
  std::vector<Share> shares_;
  std::vector<glm::vec4> tangents_;  // w = 0: not known yet
};

}  // namespace

std::vector<glm::vec4> corner_tangents(const TangentInput& mesh) {
  const std::vector<std::uint32_t> welded = weld(mesh);
  std::vector<Face> faces = make_faces(mesh, welded);
  pair_faces(faces);
  const Groups groups = group_corners(faces);
  Averager averager(mesh, faces);
  for (const Group& group : groups.list) {
    averager.add(group, std::span(groups.members).subspan(group.begin, group.end - group.begin));
  }
  return std::move(averager).finish(welded);
}

}  // namespace velarium::scene
