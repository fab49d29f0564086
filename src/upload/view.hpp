#pragma once

#include "upload/draws.hpp"
#include "upload/tables.hpp"

namespace velarium::upload {

// A camera resolved for the shape of a picture.
struct ViewMatrices {
  glm::dvec3 eye{0.0};              // world space of the scene, metres
  glm::mat3 view_from_world{1.0f};  // rotation
  glm::mat4 clip_from_view{1.0f};   // without jitter; reversed-Z
};

[[nodiscard]] ViewMatrices view_matrices(const scene::CameraInstance& camera, float aspect);

// The planes between which this view sees anything, in the world space of the scene.
[[nodiscard]] Frustum frustum_of(const ViewMatrices& view);

// What one eye sees of the tables of a snapshot, on the device. Any number of views may share tables.
struct View {
  ViewMatrices matrices;
  glm::uvec2 size{1};  // pixels
  DrawList draws;
  gpu::Buffer objects;                  // ObjectData
  gpu::Buffer sorted_indices;           // DrawList's; null where no draw is sorted
  std::vector<glm::vec4> light_bounds;  // by light: a sphere in view space around what it reaches
  gpu::Buffer light_bounds_buffer;      // the same
};

// `sorted_triangles`: make_draw_list.
[[nodiscard]] View make_view(gpu::Device& device, const Tables& tables, const scene::SceneSnapshot& snapshot,
                             const ViewMatrices& matrices, glm::uvec2 size, std::size_t sorted_triangles);

// Where a view stands in the device's world space, metres. Exactly 0 of the main eye.
[[nodiscard]] glm::dvec3 eye_from_origin(const Tables& tables, const ViewMatrices& view);

// What tells the frames of a picture apart.
struct FrameSample {
  std::uint32_t index = 0, seed = 0;
  glm::vec2 jitter{0.0f};  // of the sampled point from the pixel's centre, pixels
  float rounding = 0.0f;   // FrameUniforms'
};

[[nodiscard]] FrameUniforms frame_uniforms(const Tables& tables, const View& view, const FrameSample& sample);

}  // namespace velarium::upload
