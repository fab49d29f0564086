#include "upload/scene_tables.hpp"

#include "upload/clip_volumes.hpp"
#include "upload/lights.hpp"
#include "upload/transfer.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <glm/matrix.hpp>

#include <algorithm>

namespace velarium::upload {
namespace {

constexpr VkBufferUsageFlags kStorage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

std::vector<scene::LightInstance> shining(const std::vector<scene::LightInstance>& lights) {
  std::vector<scene::LightInstance> result;
  for (const auto& light : lights)
    if (light.light.intensity > 0.0f && light.light.color != glm::vec3(0.0f)) result.push_back(light);
  return result;
}

glm::dmat4 clip_from_world(const ViewMatrices& view) {
  glm::dmat4 view_from_world(glm::dmat3(view.view_from_world));
  view_from_world[3] = glm::dvec4(-(glm::dmat3(view.view_from_world) * view.eye), 1.0);
  return glm::dmat4(view.clip_from_view) * view_from_world;
}

Viewpoint viewpoint(const ViewMatrices& view) {
  const bool perspective = view.clip_from_view[3][3] == 0.0f;
  const glm::dvec3 backward(glm::transpose(view.view_from_world)[2]);
  return {.eye = view.eye, .backward = perspective ? glm::dvec3(0.0) : backward};
}

// Solves the projection for depth and for x, y: the forms that shading/depth.glsl takes.
glm::vec4 depth_params(const glm::mat4& p) {
  return {p[3][2], -p[3][3], p[2][2], -p[2][3]};
}

glm::vec4 ndc_to_view(const glm::mat4& p, bool perspective) {
  const glm::vec2 scale(1.0f / p[0][0], 1.0f / p[1][1]);
  const glm::vec2 offset = perspective ? glm::vec2(p[2][0], p[2][1]) : -glm::vec2(p[3][0], p[3][1]);
  return {scale.x, scale.y, offset.x * scale.x, offset.y * scale.y};
}

}  // namespace

ViewMatrices view_matrices(const scene::CameraInstance& camera, float aspect) {
  return {.eye = glm::dvec3(camera.world_from_view[3]),
          .view_from_world = glm::transpose(glm::mat3(camera.world_from_view)),
          .clip_from_view = scene::clip_from_view(camera.camera, aspect)};
}

SceneTables make_scene_tables(gpu::Device& device, const GpuScene& scene, const scene::Moment& moment,
                              const ViewMatrices& view, std::size_t sorted_triangles) {
  SceneTables tables{.gpu = &scene};
  tables.draws =
      make_draw_list(scene.scene(), moment, frustum_of(clip_from_world(view)), viewpoint(view), sorted_triangles);
  tables.objects = make_buffer(device, tables.draws.objects, kStorage);
  if (!tables.draws.sorted_indices.empty())
    tables.sorted_indices = make_buffer(device, tables.draws.sorted_indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  auto lights = gpu_lights(shining(moment.lights), view.eye, scene.projectors().pictures);
  if (lights.size() > kMaxLights)
    throw Error(ErrorCode::unsupported, scene.scene().source,
                fmt::format("{} lights shine; a picture takes {} at most", lights.size(), kMaxLights));
  tables.light_ranges = light_ranges(lights);
  if (std::any_of(lights.begin(), lights.end(),
                  [](const GpuLight& light) { return (light.flags & shading::kLightCastsShadow) != 0; }))
    tables.casters = make_casters(scene.scene(), moment, view.eye);
  tables.caster_objects = make_buffer(device, tables.casters.objects, kStorage);
  auto bounds = light_bounds(lights, view.view_from_world);
  if (any_clipped(lights)) {
    const auto volumes = make_clip_volumes(scene.scene(), moment, view.eye);
    limit_to_clip_volumes(lights, volumes, view.view_from_world, bounds);
    tables.clip_volumes = make_buffer(device, volumes.records, kStorage);
  }
  tables.light_bounds = make_buffer(device, bounds, kStorage);
  tables.lights = make_buffer(device, lights, kStorage);
  tables.host_lights = std::move(lights);
  tables.frame = gpu::Buffer(device, sizeof(FrameUniforms), kStorage, gpu::MemoryUse::upload);
  return tables;
}

void set_camera(FrameUniforms& frame, const ViewMatrices& view, glm::uvec2 size, glm::vec2 jitter) {
  glm::mat4 projection = view.clip_from_view;
  // To sample at +jitter from the pixel's centre, the picture moves the other way.
  const glm::vec2 shift = -2.0f * jitter / glm::vec2(size);
  for (int column = 0; column < 4; ++column) {
    projection[column][0] += shift.x * projection[column][3];
    projection[column][1] += shift.y * projection[column][3];
  }
  const bool perspective = projection[3][3] == 0.0f;
  frame.view_from_world = glm::mat4(view.view_from_world);
  frame.clip_from_world = projection * frame.view_from_world;
  frame.perspective = perspective ? 1.0f : 0.0f;
  frame.depth_params = depth_params(projection);
  frame.ndc_to_view = ndc_to_view(projection, perspective);
  const glm::vec2 pixels(size);
  frame.size = {pixels.x, pixels.y, 1.0f / pixels.x, 1.0f / pixels.y};
}

}  // namespace velarium::upload
