#include "passes/lighting/lighting.hpp"

namespace velarium::lighting {
namespace {

using graph::Access;

constexpr std::uint32_t kShader[] =
#include "shaders/lighting.comp.inc"
    ;

// The azimuth wraps around.
constexpr gpu::SamplerDesc kEquirect{.wrap_u = VK_SAMPLER_ADDRESS_MODE_REPEAT};

// Threads that share a tile. A software driver keeps each thread's state at each barrier, so that there few threads
// with many pixels each are faster; the picture is the same.
constexpr std::uint32_t kThreads = 128;
constexpr std::uint32_t kThreadsOnHost = 16;

// llvmpipe ends all loops of a thread after 65535 turns, taken together (Mesa 22.3, LP_MAX_TGSI_LOOP_ITERATIONS):
// lights after that would be missing.
constexpr std::uint64_t kMostTurns = 65535;

// What one pixel may need: the loops over the lists, which have three parts, and for each light those of its shadow.
std::uint64_t turns_a_pixel(const passes::ShadingInputs& in) {
  const auto& s = in.settings;
  const std::uint64_t lights = in.scene.light_ranges.count, words = lights / 32 + 3;
  // Search, layers, filter; half as many taps find and filter what dyes light.
  const auto taps = in.scene.light_ranges.sized ? 4 * s.local_shadows.taps : 2;
  const bool maps = in.shadow_atlas.version != 0;
  const auto steps = s.contact_shadows.enabled ? s.contact_shadows.steps : 0;  // of one light
  return words + lights * static_cast<std::uint64_t>(1 + (maps ? taps : 0)) + static_cast<std::uint64_t>(steps);
}

std::uint32_t threads_on_host(const passes::ShadingInputs& in) {
  constexpr std::uint32_t kPixels = upload::kTileSize * upload::kTileSize;
  std::uint32_t threads = kThreadsOnHost;
  while (threads < kThreads && turns_a_pixel(in) * (kPixels / threads) > kMostTurns) threads *= 2;
  return threads;
}

VkDeviceSize list_bytes(const gpu::ImageDesc& size, std::uint32_t light_count) {
  const auto tiles = [](std::uint32_t pixels) { return (pixels + upload::kTileSize - 1) / upload::kTileSize; };
  return VkDeviceSize{4} * tiles(size.width) * tiles(size.height) * ((light_count + 31) / 32);
}

// kLamps of the shader.
std::uint32_t lamps_constant(const Inputs& in) {
  if (in.shading.settings.lighting.path == LightingPath::volumes) return in.lamps.version != 0 ? 2 : 0;
  return in.shading.scene.light_ranges.count > 0 ? 1 : 0;
}

}  // namespace

Outputs add(graph::Graph& graph, const Inputs& in) {
  const auto& scene = in.shading.scene;
  const bool lists = !scene.draws.blended.empty() && scene.light_ranges.count > 0;
  auto& pass = graph.pass("lighting");
  passes::read(pass, in.surface, Access::compute_sample);
  passes::read(pass, in.shading, Access::compute_sample);
  if (in.lamps.version != 0) pass.read(in.lamps, Access::compute_sample);
  Outputs out{.hdr = pass.write(in.hdr, Access::compute_storage)};
  const auto size = graph.desc(in.hdr);
  const auto list_buffer = pass.write(
      graph.buffer("forward_lists", lists ? list_bytes(size, scene.light_ranges.count) : 4), Access::compute_storage);
  if (lists) out.forward_lists = list_buffer;

  auto constants = passes::shading_constants(in.shading);
  constants.insert(constants.end(), {in.shading.settings.lighting.path == LightingPath::tiled ? 1u : 0u,
                                     lists ? 1u : 0u, lamps_constant(in)});
  pass.run([in, out, list_buffer, size, constants](graph::Context& c) {
    auto with_threads = constants;
    with_threads.push_back(c.tools().device.caps().host_is_device ? threads_on_host(in.shading) : kThreads);
    const auto& pipeline = c.tools().pipelines.compute(kShader, with_threads);
    c.bind(pipeline);
    auto own = c.set(pipeline, 0);
    own.buffer(0, in.shading.scene.frame)
        .storage(6, out.hdr)
        .sampled(7, in.shading.environment.background, kEquirect)
        .buffer(8, in.shading.scene.light_bounds)
        .buffer(9, list_buffer);
    passes::bind(own, in.surface);
    if (in.lamps.version != 0)
      own.sampled(10, in.lamps, gpu::kNearest);
    else
      own.sampled(10, in.shading.environment.background);  // bound, never read
    own.bind();
    auto shared = c.set(pipeline, 1);
    passes::bind(shared, in.shading);
    shared.bind();
    c.dispatch(size.width, size.height, upload::kTileSize, upload::kTileSize);
  });
  return out;
}

}  // namespace velarium::lighting
