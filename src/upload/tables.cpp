#include "upload/tables.hpp"

#include "upload/transfer.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

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

bool casts_shadow(const GpuLight& light) {
  return (light.flags & shading::kLightCastsShadow) != 0;
}

}  // namespace

Tables make_tables(gpu::Device& device, const GpuScene& scene, const scene::SceneSnapshot& snapshot,
                   const glm::dvec3& origin) {
  Tables tables{.gpu = &scene,
                .snapshot = &snapshot,
                .origin = origin,
                .deformed = make_deformed(device, scene.scene(), snapshot)};
  tables.lights = gpu_lights(shining(snapshot.lights), origin, scene.projectors().pictures);
  if (tables.lights.size() > kMaxLights)
    throw Error(ErrorCode::unsupported, scene.scene().source,
                fmt::format("{} lights shine; a picture takes {} at most", tables.lights.size(), kMaxLights));
  tables.light_ranges = light_ranges(tables.lights);
  if (std::ranges::any_of(tables.lights, casts_shadow)) tables.casters = make_casters(scene.scene(), snapshot, origin);
  tables.caster_objects = make_buffer(device, tables.casters.objects, kStorage);
  if (any_clipped(tables.lights)) {
    tables.clip_volumes = make_clip_volumes(scene.scene(), snapshot, origin);
    tables.clip_volume_buffer = make_buffer(device, tables.clip_volumes.records, kStorage);
  }
  tables.light_buffer = make_buffer(device, tables.lights, kStorage);
  return tables;
}

}  // namespace velarium::upload
