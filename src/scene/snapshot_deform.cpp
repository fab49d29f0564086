#include "scene/snapshot_deform.hpp"

#include "core/assert.hpp"
#include "core/jobs.hpp"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>

namespace velarium::scene {
namespace {

struct Vertex {
  glm::vec3 position{0.0f}, normal{0.0f}, tangent{0.0f};
  float bitangent_sign = 1.0f;
};

// Nothing to say where the vector has no length: it is left as it is.
glm::vec3 unit(const glm::vec3& v) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : v;
}

void morph(Vertex& vertex, const Deformation& by, std::size_t i) {
  const auto& targets = by.primitive->morph_targets;
  const std::size_t count = std::min(targets.size(), by.morph_weights.size());
  for (std::size_t t = 0; t < count; ++t) {
    const float weight = by.morph_weights[t];
    if (weight == 0.0f) continue;
    if (!targets[t].positions.empty()) vertex.position += weight * targets[t].positions[i];
    if (!targets[t].normals.empty()) vertex.normal += weight * targets[t].normals[i];
    if (!targets[t].tangents.empty()) vertex.tangent += weight * targets[t].tangents[i];
  }
}

void skin(Vertex& vertex, const Deformation& by, std::size_t i) {
  const Primitive& p = *by.primitive;
  glm::mat4 blend(0.0f);
  for (std::size_t set = 0; set < p.skin_sets; ++set) {
    const std::size_t at = set * p.vertex_count() + i;
    for (int k = 0; k < 4; ++k) {
      if (p.weights[at][k] != 0.0f) blend += p.weights[at][k] * by.world_from_bind[p.joints[at][k]];
    }
  }
  const glm::mat3 linear(blend);
  // Cofactors: the inverse transpose times the determinant, defined even where there is no inverse.
  const glm::mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                            glm::cross(linear[0], linear[1]));
  const float orientation = glm::dot(linear[0], cofactors[0]) < 0.0f ? -1.0f : 1.0f;
  vertex.position = glm::vec3(blend * glm::vec4(vertex.position, 1.0f));
  vertex.normal = orientation * (cofactors * vertex.normal);
  vertex.tangent = linear * vertex.tangent;
  vertex.bitangent_sign *= orientation;
}

void deform_range(const Deformation& by, std::size_t begin, std::size_t end, VertexFrames& out) {
  const VertexFrames& rest = by.primitive->vertices;
  for (std::size_t i = begin; i < end; ++i) {
    Vertex vertex;
    vertex.position = rest.positions[i];
    if (!rest.normals.empty()) vertex.normal = rest.normals[i];
    if (!rest.tangents.empty()) {
      vertex.tangent = glm::vec3(rest.tangents[i]);
      vertex.bitangent_sign = rest.tangents[i].w;
    }
    morph(vertex, by, i);
    if (!by.world_from_bind.empty()) skin(vertex, by, i);
    const glm::vec3 normal = unit(vertex.normal);
    out.positions[i] = vertex.position;
    if (!rest.normals.empty()) out.normals[i] = normal;
    if (!rest.tangents.empty()) {
      const glm::vec3 tangent = unit(vertex.tangent - normal * glm::dot(normal, vertex.tangent));
      out.tangents[i] = glm::vec4(tangent, vertex.bitangent_sign);
    }
  }
}

}  // namespace

std::vector<VertexFrames> deformed_vertices(std::span<const Deformation> deformations) {
  constexpr std::size_t kRange = 4096;  // vertices a job: some 100 microseconds, far above the cost of starting one
  struct Job {
    std::size_t deformation, begin, end;
  };
  std::vector<VertexFrames> out(deformations.size());
  std::vector<Job> jobs;
  for (std::size_t d = 0; d < deformations.size(); ++d) {
    const VertexFrames& rest = deformations[d].primitive->vertices;
    const std::size_t count = rest.positions.size();
    out[d].positions.resize(count);
    out[d].normals.resize(rest.normals.size());
    out[d].tangents.resize(rest.tangents.size());
    for (std::size_t i = 0; i < count; i += kRange) jobs.push_back({d, i, std::min(i + kRange, count)});
  }
  parallel_for(jobs.size(), [&](std::size_t j) {
    deform_range(deformations[jobs[j].deformation], jobs[j].begin, jobs[j].end, out[jobs[j].deformation]);
  });
  return out;
}

}  // namespace velarium::scene
