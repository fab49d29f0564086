#include "reference/tracer.hpp"

#include "reference/passes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace velarium::reference {
namespace {

// Each doubling of paths lets textures be half a mip sharper, as the renderer's do with its frames; past four times,
// nothing is gained.
constexpr float kMostSharpness = 4.0f;

Transport transport_of(const Job& job) {
  const auto& s = job.settings;
  const auto bounces = static_cast<std::uint32_t>(s.reference.max_bounces) + 1;
  Transport t;
  switch (s.reference.transport) {
    case velarium::Transport::direct:
    case velarium::Transport::direct_env:
      t.reflections = 1;
      break;
    case velarium::Transport::one_bounce:
      t.reflections = std::min(bounces, 2u);
      break;
    case velarium::Transport::full:
      t.reflections = bounces;
      break;
  }
  t.environment = s.reference.transport != velarium::Transport::direct;
  t.emissive_lighting = s.reference.emissive_lighting;
  t.shadows = s.reference.shadows;
  t.clamp = s.reference.clamp;
  t.min_highlight_alpha = s.lighting.min_highlight_alpha;
  t.model = static_cast<std::uint32_t>(s.lighting.model);
  t.multi_scatter = s.lighting.multi_scatter && s.lighting.model == ShadingModel::gltf;
  t.background = job.background;
  t.opaque_background = job.opaque_background;
  t.sharpness = std::min(std::sqrt(static_cast<float>(s.reference.spp)), kMostSharpness);
  return t;
}

std::uint64_t skipped_primitives(const Job& job) {
  return static_cast<std::uint64_t>(
      std::count_if(job.snapshot.instances.begin(), job.snapshot.instances.end(),
                    [&](auto& i) { return job.scene.primitives[i.primitive].topology != scene::Topology::triangles; }));
}

void note_scene(const Job& job, const std::vector<Object>& objects, const Lights& lights,
                std::vector<std::string>& notes) {
  if (const std::uint64_t skipped = skipped_primitives(job); skipped > 0)
    notes.push_back(fmt::format("{} primitives of points or lines are left out: rays do not meet them", skipped));
  if (objects.empty()) notes.emplace_back("the scene has no triangles: the picture shows what lies behind them");
  if (job.environment != nullptr && !lights.has_environment())
    notes.emplace_back("the environment is black and lights nothing");
  if (job.settings.ambient_lights.enabled && !job.snapshot.ambient_lights.empty())
    notes.emplace_back("ambient lights are left out: paths follow light that is there");
}

}  // namespace

Result trace(const Job& job) {
  const auto& s = job.settings;
  const glm::dvec3 eye(job.camera.world_from_view[3]);
  const std::vector<Object> objects = objects_of(job.scene, job.snapshot, eye);
  const Materials materials(job.scene);
  const Geometry geometry(objects, materials);
  const Lights lights(job.lights, job.projectors, job.clip_records, job.environment, s.environment.rotation,
                      s.environment.intensity, objects, materials);
  const Camera camera(job.camera, job.width, job.height);
  const EnergyTable energy(job.energy, job.energy_size);
  const PathTracer tracer({camera, objects, materials, geometry, lights, energy}, transport_of(job),
                          static_cast<std::uint32_t>(s.frame.seed));
  Result result{.film = Film(job.width, job.height)};
  note_scene(job, objects, lights, result.notes);
  trace_passes(tracer, s.reference, job.on_progress, result);
  if (const std::uint64_t lost = result.film.lost_paths(); lost > 0)
    result.notes.push_back(fmt::format("{} paths found light that is not a finite number and were left out", lost));
  return result;
}

}  // namespace velarium::reference
