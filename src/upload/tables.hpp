#pragma once

#include "upload/casters.hpp"
#include "upload/clip_volumes.hpp"
#include "upload/gpu_scene.hpp"
#include "upload/lights.hpp"

namespace velarium::upload {

// What a snapshot looks like from anywhere, on the device: the parts that all views of a picture share.
struct Tables {
  const GpuScene* gpu = nullptr;
  const scene::SceneSnapshot* snapshot = nullptr;  // what they were made of; techniques make tables of their own of it
  glm::dvec3 origin{0.0};  // world space of the scene, metres: where the device's world space has its origin
  DeformedVertices deformed;
  CasterTable casters;         // empty where no light casts shadows
  gpu::Buffer caster_objects;  // ObjectData
  std::vector<GpuLight> lights;
  gpu::Buffer light_buffer;  // the same
  LightRanges light_ranges{};
  ClipVolumeTable clip_volumes;    // empty where no light ends at a volume
  gpu::Buffer clip_volume_buffer;  // its records; null where there are none
  TextureQuality texture_quality;
};

// Lights that shine on nothing (no intensity) are left out. origin: the main eye, so that what stands near to it keeps
// its digits. Throws Error(unsupported) for more than kMaxLights lights.
// `scene` and `snapshot` must outlive the tables.
[[nodiscard]] Tables make_tables(gpu::Device& device, const GpuScene& scene, const scene::SceneSnapshot& snapshot,
                                 const glm::dvec3& origin);

}  // namespace velarium::upload
