#include "upload/view.hpp"

#include "upload/transfer.hpp"

#include <glm/matrix.hpp>

namespace velarium::upload {
namespace {

constexpr VkBufferUsageFlags kStorage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

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

// From the device's world space.
glm::mat4 view_from_device(const Tables& tables, const ViewMatrices& view) {
  const glm::dvec3 offset = -(glm::dmat3(view.view_from_world) * eye_from_origin(tables, view));
  glm::mat4 result(view.view_from_world);
  result[3] = glm::vec4(glm::vec3(offset) + 0.0f, 1.0f);  // 0 has no sign
  return result;
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
          .view_from_world = glm::transpose(glm::mat3(glm::mat4(camera.world_from_view))),
          .clip_from_view = scene::clip_from_view(camera.camera, aspect)};
}

Frustum frustum_of(const ViewMatrices& view) {
  return frustum_of(clip_from_world(view));
}

glm::dvec3 eye_from_origin(const Tables& tables, const ViewMatrices& view) {
  return view.eye - tables.origin;
}

View make_view(gpu::Device& device, const Tables& tables, const scene::SceneSnapshot& snapshot,
               const ViewMatrices& matrices, glm::uvec2 size, std::size_t sorted_triangles) {
  View view{.matrices = matrices, .size = size};
  view.draws = make_draw_list(tables.gpu->scene(), snapshot, tables.origin, frustum_of(matrices), viewpoint(matrices),
                              sorted_triangles);
  view.objects = make_buffer(device, view.draws.objects, kStorage);
  if (!view.draws.sorted_indices.empty())
    view.sorted_indices = make_buffer(device, view.draws.sorted_indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  const glm::mat4 view_from_world = view_from_device(tables, matrices);
  view.light_bounds = light_bounds(tables.lights, view_from_world);
  limit_to_clip_volumes(tables.lights, tables.clip_volumes, view_from_world, view.light_bounds);
  view.light_bounds_buffer = make_buffer(device, view.light_bounds, kStorage);
  return view;
}

FrameUniforms frame_uniforms(const Tables& tables, const View& view, const FrameSample& sample) {
  glm::mat4 projection = view.matrices.clip_from_view;
  const glm::vec2 pixels(view.size);
  // To sample at +jitter from the pixel's centre, the picture moves the other way.
  const glm::vec2 shift = -2.0f * sample.jitter / pixels;
  for (int column = 0; column < 4; ++column) {
    projection[column][0] += shift.x * projection[column][3];
    projection[column][1] += shift.y * projection[column][3];
  }
  const bool perspective = projection[3][3] == 0.0f;
  const glm::mat4 view_from_world = view_from_device(tables, view.matrices);
  return {.clip_from_world = projection * view_from_world,
          .view_from_world = view_from_world,
          .eye = glm::vec4(glm::vec3(eye_from_origin(tables, view.matrices)), 0.0f),
          .ndc_to_view = ndc_to_view(projection, perspective),
          .depth_params = depth_params(projection),
          .size = {pixels.x, pixels.y, 1.0f / pixels.x, 1.0f / pixels.y},
          .perspective = perspective ? 1.0f : 0.0f,
          .frame_index = sample.index,
          .seed = sample.seed,
          .rounding = sample.rounding};
}

}  // namespace velarium::upload
