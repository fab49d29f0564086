#include "upload/lights.hpp"

#include "upload/projectors.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::upload {
namespace {

// Beyond this, lux or candela, what thousands of lights reflect at once would be no number of 32 bits: a highlight is
// up to 6e4 times as bright (kMinAlphaPunctual), a light at hand 1e6 times (kMinLightDistance), and kMaxLights are 2e4.
constexpr float kBrightestLight = 1e23f;

float gpu_kind(scene::LightKind kind) {
  switch (kind) {
    case scene::LightKind::directional:
      return shading::kLightDirectional;
    case scene::LightKind::point:
      return shading::kLightPoint;
    case scene::LightKind::spot:
      return shading::kLightSpot;
  }
  return shading::kLightPoint;
}

float gpu_falloff(scene::Falloff falloff) {
  return falloff == scene::Falloff::bulb ? shading::kFalloffBulb : shading::kFalloffInverseSquare;
}

GpuLight gpu_light(const scene::LightInstance& instance, const glm::dvec3& origin,
                   std::span<const scene::Projector> pictures) {
  const scene::Light& light = instance.light;
  const glm::vec2 cone = shading::spot_scale_offset(light.inner_cone, light.outer_cone);
  const bool directional = light.kind == scene::LightKind::directional;
  const float size = directional ? std::sin(light.angular_radius) : light.radius;
  return {.position_range = glm::vec4(glm::vec3(instance.position - origin), light.range),
          .direction = glm::vec4(instance.direction, gpu_kind(light.kind)),
          .color = glm::vec4(glm::min(light.color * light.intensity, kBrightestLight), size),
          .cone = {cone.x, cone.y, std::cos(light.outer_cone), gpu_falloff(light.falloff)},
          .projector = glm::vec4(instance.right, std::tan(0.5f * light.projector.field_of_view)),
          .projector_layer = projector_layer(light.projector, pictures),
          .clip_volume = static_cast<std::uint32_t>(light.clip_volume + 1),
          .flags = light.casts_shadow ? shading::kLightCastsShadow : 0u};
}

std::uint32_t sun_of(const std::vector<GpuLight>& lights) {
  std::uint32_t sun = kNoSun;
  float brightest = 0.0f;
  for (std::uint32_t i = 0; i < lights.size() && shading::is_directional(lights[i]); ++i) {
    const float lux = shading::luminance(glm::vec3(lights[i].color));
    if ((lights[i].flags & shading::kLightCastsShadow) == 0 || lux <= brightest) continue;
    sun = i;
    brightest = lux;
  }
  return sun;
}

// The offset is added last, so that places relative to an eye at the origin keep their bits.
glm::vec3 to_view(const glm::mat4& view_from_world, const glm::vec3& position) {
  return glm::mat3(view_from_world) * position + glm::vec3(view_from_world[3]);
}

glm::vec4 bounding_sphere(const GpuLight& light) {
  const float radius = shading::light_cull_radius(light);
  const glm::vec3 position(light.position_range);
  if (!shading::is_spot(light)) return {position, radius};
  return shading::spot_bounding_sphere(position, glm::vec3(light.direction), radius, light.cone.z);
}

}  // namespace

std::vector<GpuLight> gpu_lights(const std::vector<scene::LightInstance>& lights, const glm::dvec3& origin,
                                 std::span<const scene::Projector> pictures) {
  std::vector<GpuLight> result;
  result.reserve(lights.size());
  for (const auto& instance : lights) result.push_back(gpu_light(instance, origin, pictures));
  std::stable_sort(result.begin(), result.end(),
                   [](const GpuLight& a, const GpuLight& b) { return a.direction.w < b.direction.w; });
  return result;
}

LightRanges light_ranges(const std::vector<GpuLight>& lights) {
  const auto begin_of = [&](float kind) {
    const auto first = std::partition_point(lights.begin(), lights.end(),
                                            [&](const GpuLight& light) { return light.direction.w < kind; });
    return static_cast<std::uint32_t>(first - lights.begin());
  };
  return {.first_point = begin_of(shading::kLightPoint),
          .first_spot = begin_of(shading::kLightSpot),
          .count = static_cast<std::uint32_t>(lights.size()),
          .sun = sun_of(lights)};
}

bool any_area_light(const std::vector<GpuLight>& lights) {
  return std::ranges::any_of(lights, [](const GpuLight& light) { return light.color.w > 0.0f; });
}

bool any_projector(const std::vector<GpuLight>& lights) {
  return std::ranges::any_of(lights, [](const GpuLight& light) { return light.projector_layer != 0; });
}

std::vector<glm::vec4> light_bounds(const std::vector<GpuLight>& lights, const glm::mat4& view_from_world) {
  std::vector<glm::vec4> result;
  for (const auto& light : lights) {
    const glm::vec4 sphere = bounding_sphere(light);
    result.emplace_back(to_view(view_from_world, glm::vec3(sphere)), sphere.w);
  }
  return result;
}

}  // namespace velarium::upload
