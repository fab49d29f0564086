#include "upload/vertices.hpp"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::upload {
namespace {

std::int16_t snorm16(float value) {
  return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * 32767.0f));
}

std::array<std::int16_t, 4> pack_direction(const glm::vec4& v) {
  return {snorm16(v.x), snorm16(v.y), snorm16(v.z), snorm16(v.w)};
}

glm::vec2 uv_at(const scene::Primitive& primitive, std::uint32_t set, std::size_t vertex) {
  const auto& uvs = primitive.uv[set];
  return uvs.empty() ? glm::vec2(0.0f) : uvs[vertex];
}

}  // namespace

std::vector<gpu::VertexBinding> vertex_bindings() {
  return {{kPositionStream, sizeof(glm::vec3)}, {kAttributeStream, sizeof(PackedAttributes)}};
}

std::vector<gpu::VertexAttribute> vertex_attributes() {
  return {{0, kPositionStream, VK_FORMAT_R32G32B32_SFLOAT, 0},
          {1, kAttributeStream, VK_FORMAT_R16G16B16A16_SNORM, offsetof(PackedAttributes, normal)},
          {2, kAttributeStream, VK_FORMAT_R16G16B16A16_SNORM, offsetof(PackedAttributes, tangent)},
          {3, kAttributeStream, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(PackedAttributes, uv)},
          {4, kAttributeStream, VK_FORMAT_R16G16B16A16_SFLOAT, offsetof(PackedAttributes, color)}};
}

void pack_attributes(const scene::Primitive& primitive, const scene::VertexFrames& frames, const UvChoice& uv,
                     std::span<PackedAttributes> out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    const glm::vec3 normal = frames.normals.empty() ? glm::vec3(0.0f) : frames.normals[i];
    const glm::vec4 tangent = frames.tangents.empty() ? glm::vec4(0.0f) : frames.tangents[i];
    const glm::vec4 color = primitive.colors.empty() ? glm::vec4(1.0f) : primitive.colors[i];
    const glm::vec2 uv0 = uv_at(primitive, uv.sets[0], i), uv1 = uv_at(primitive, uv.sets[1], i);
    out[i] = {pack_direction(glm::vec4(normal, 0.0f)),
              pack_direction(tangent),
              {uv0.x, uv0.y, uv1.x, uv1.y},
              {glm::packHalf1x16(color.x), glm::packHalf1x16(color.y), glm::packHalf1x16(color.z),
               glm::packHalf1x16(color.w)}};
  }
}

}  // namespace velarium::upload
