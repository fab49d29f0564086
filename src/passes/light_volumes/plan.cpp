#include "passes/light_volumes/plan.hpp"

#include "upload/lights.hpp"

#include <optional>

#include "shading/host.hpp"

namespace velarium::light_volumes {
namespace {

// Marking costs as much as drawing the body twice, and every pixel of the screen a look at its mark: from here on it
// was seen to pay.
constexpr float kMarkedShare = 0.25f;

// Up to here a body has more vertices than its quad has pixels.
constexpr float kQuadPixels = 400.0f;

std::uint32_t kind_of(const upload::GpuLight& light) {
  if (shading::is_directional(light)) return 0;
  return shading::is_spot(light) ? 2 : 1;
}

Shape body_of(const upload::GpuLight& light) {
  return shading::is_spot(light) && light.cone.z >= shading::kConeLeastCosine ? Shape::cone : Shape::sphere;
}

// bounds: a view space sphere.
std::optional<VolumeDraw> draw_of(const upload::GpuLight& light, const glm::vec4& bounds,
                                  const upload::FrameUniforms& frame) {
  VolumeDraw draw{.kind = kind_of(light)};
  if (shading::light_cull_radius(light) >= shading::kUnboundedRadius) return draw;
  const glm::vec3 center(bounds);
  const auto on_screen = shading::sphere_screen_bounds(center, bounds.w, frame.ndc_to_view, frame.perspective);
  const float share = shading::screen_share(on_screen);
  if (share == 0.0f) return std::nullopt;
  draw.marked = share >= kMarkedShare;
  draw.shape = !draw.marked && share * frame.size.x * frame.size.y < kQuadPixels ? Shape::quad : body_of(light);
  return draw;
}

bool joins(const VolumeDraw& last, const VolumeDraw& next) {
  return !last.marked && !next.marked && last.shape == next.shape && last.kind == next.kind &&
         last.first_light + last.light_count == next.first_light;
}

}  // namespace

std::vector<VolumeDraw> plan(std::span<const upload::GpuLight> lights, std::span<const glm::vec4> bounds,
                             const upload::FrameUniforms& frame) {
  std::vector<VolumeDraw> draws;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    auto draw = draw_of(lights[i], bounds[i], frame);
    if (!draw) continue;
    draw->first_light = i;
    if (!draws.empty() && joins(draws.back(), *draw))
      ++draws.back().light_count;
    else
      draws.push_back(*draw);
  }
  return draws;
}

}  // namespace velarium::light_volumes
