#include "passes/lighting/lighting.hpp"

#include "upload/io.hpp"

namespace velarium::lighting {
namespace {

namespace own {
using namespace shading;
#include "passes/lighting/lighting_own_io.glsl"
}  // namespace own

using graph::Access;

constexpr std::uint32_t kShader[] =
#include "shaders/passes/lighting/lighting.comp.inc"
    ;

// Threads that share a tile. A software driver keeps each thread's state at each barrier, so that there few threads
// with many pixels each are faster; the picture is the same.
constexpr std::uint32_t kThreads = 128;
constexpr std::uint32_t kThreadsOnHost = 16;

// llvmpipe ends all loops of a thread after 65535 turns, taken together (Mesa 22.3, LP_MAX_TGSI_LOOP_ITERATIONS):
// lights after that would be missing.
constexpr std::uint64_t kMaxLoopIterations = 65535;

// What one pixel may need: the loops over the lists, which have three parts, those of illumination, and the march of
// one contact shadow.
std::uint64_t loop_iterations_per_pixel(const Inputs& in) {
  const std::uint64_t lights = in.illumination.scene.tables.light_ranges.count, words = lights / 32 + 3;
  return words + passes::loop_iterations(in.illumination, lights) + in.contact.steps;
}

std::uint32_t threads_on_host(const Inputs& in) {
  constexpr std::uint32_t kPixels = upload::kTileSize * upload::kTileSize;
  std::uint32_t threads = kThreadsOnHost;
  while (threads < kThreads && loop_iterations_per_pixel(in) * (kPixels / threads) > kMaxLoopIterations) threads *= 2;
  return threads;
}

VkDeviceSize list_bytes(const gpu::ImageDesc& size, std::uint32_t light_count) {
  const auto tiles = [](std::uint32_t pixels) { return (pixels + upload::kTileSize - 1) / upload::kTileSize; };
  return VkDeviceSize{4} * tiles(size.width) * tiles(size.height) * ((light_count + 31) / 32);
}

std::uint32_t punctual(const Inputs& in) {
  if (in.path == LightingPath::volumes) return in.volume_light.version != 0 ? own::kPunctualVolumes : own::kNoPunctual;
  return in.illumination.scene.tables.light_ranges.count > 0 ? own::kPunctualHere : own::kNoPunctual;
}

// lists: are those of forward surfaces to be written?
gpu::Specialization specialization(const Inputs& in, bool lists, bool host_is_device) {
  auto constants = passes::specialization(in.illumination);
  specialize(constants, in.contact);
  return constants.set(own::kTiled, in.path == LightingPath::tiled)
      .set(own::kForwardLists, lists)
      .set(own::kPunctual, punctual(in))
      .set(own::kTileThreads, host_is_device ? threads_on_host(in) : kThreads);
}

}  // namespace

Outputs add(graph::Graph& graph, const Inputs& in) {
  const auto& scene = in.illumination.scene;
  const std::uint32_t light_count = scene.tables.light_ranges.count;
  const bool lists = !scene.view.draws.blended.empty() && light_count > 0;
  auto& pass = graph.pass("lighting");
  gbuffer::declare(pass, in.gbuffer, Access::compute_sample);
  passes::declare(pass, in.illumination, Access::compute_sample);
  if (in.volume_light.version != 0) pass.read(in.volume_light, Access::compute_sample);
  Outputs out{.hdr = pass.write(in.hdr, Access::compute_storage)};
  const auto size = graph.desc(in.hdr);
  const auto list_buffer =
      pass.write(graph.buffer("forward_lists", lists ? list_bytes(size, light_count) : 4), Access::compute_storage);
  if (lists) out.forward_lists = list_buffer;

  pass.run([in, out, list_buffer, size, lists](graph::Context& c) {
    const auto& pipeline =
        c.tools().pipelines.compute(kShader, specialization(in, lists, c.tools().device.caps().host_is_device));
    c.bind(pipeline);
    auto set = c.set(pipeline, 0);
    set.buffer(upload::io::FrameBuffer, in.illumination.scene.frame_buffer)
        .storage(own::hdr, out.hdr)
        .sampled(own::background_map, in.illumination.environment.background)
        .buffer(own::BoundsBuffer, in.illumination.scene.view.light_bounds_buffer)
        .buffer(own::OwnListBuffer, list_buffer)
        .sampled(own::volume_light, in.volume_light);
    gbuffer::bind(set, in.gbuffer);
    set.bind();
    auto shared = c.set(pipeline, 1);
    passes::bind(shared, in.illumination);
    contact_shadows::bind(shared, in.contact);
    shared.bind();
    c.dispatch(size.width, size.height, upload::kTileSize, upload::kTileSize);
  });
  return out;
}

}  // namespace velarium::lighting
