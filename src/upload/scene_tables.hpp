#pragma once

#include "upload/gpu_scene.hpp"

namespace velarium::upload {

// A camera resolved for a picture size.
struct ViewMatrices {
  glm::dvec3 eye{0.0};              // world space, metres
  glm::mat3 view_from_world{1.0f};  // rotation
  glm::mat4 clip_from_view{1.0f};   // without jitter; reversed-Z
};

[[nodiscard]] ViewMatrices view_matrices(const scene::CameraInstance& camera, float aspect);

// Everything that a moment looks like from this view. Lights that shine on nothing (no intensity) are left out.
// `sorted_triangles`: make_draw_list. Throws Error(unsupported) for more than kMaxLights lights.
[[nodiscard]] SceneTables make_scene_tables(gpu::Device& device, const GpuScene& scene, const scene::Moment& moment,
                                            const ViewMatrices& view, std::size_t sorted_triangles);

// The parts of FrameUniforms that follow from the camera; `jitter`: offset of the sampled point from
// the pixel's centre, in pixels.
void set_camera(FrameUniforms& frame, const ViewMatrices& view, glm::uvec2 size, glm::vec2 jitter);

}  // namespace velarium::upload
