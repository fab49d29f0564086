#include "passes/lighting/lighting.hpp"

#include "graph/context.hpp"

namespace velarium::lighting {
namespace {

using graph::Access;

constexpr std::uint32_t kShader[] =
#include "shaders/lighting.comp.inc"
    ;

constexpr gpu::SamplerDesc kNearest{.mag = VK_FILTER_NEAREST, .min = VK_FILTER_NEAREST};
// The azimuth wraps around.
constexpr gpu::SamplerDesc kEquirect{.wrap_u = VK_SAMPLER_ADDRESS_MODE_REPEAT};

// Threads that share a tile. A software driver keeps each thread's state at each barrier, so that there few threads
// with many pixels each are faster; the picture is the same.
constexpr std::uint32_t kThreads = 128;
constexpr std::uint32_t kThreadsOnHost = 16;

VkDeviceSize list_bytes(const gpu::ImageDesc& size, std::uint32_t light_count) {
  const auto tiles = [](std::uint32_t pixels) { return (pixels + upload::kTileSize - 1) / upload::kTileSize; };
  return VkDeviceSize{4} * tiles(size.width) * tiles(size.height) * ((light_count + 31) / 32);
}

}  // namespace

gpu::Specialization shading_constants(const Settings& settings, const Environment& environment) {
  const bool ryse = settings.model == ShadingModel::ryse;
  // Compensation would undo the darkening that Ryse's visibility term is meant to have.
  const bool multi_scatter = settings.multi_scatter && !ryse;
  gpu::Specialization constants(kSharedConstants);
  constants[1] = ryse ? shading::kModelRyse : shading::kModelGltf;
  constants[2] = multi_scatter ? 1u : 0u;
  constants[3] = settings.occlusion ? 1u : 0u;
  constants[4] = environment.present ? 1u : 0u;
  constants[5] = environment.diffuse == DiffuseEnvironment::sh ? 1u : 0u;
  return constants;
}

Outputs add(graph::Graph& graph, const Inputs& in, const Settings& settings) {
  const bool lists = !in.scene.draws.blended.empty() && in.scene.light_ranges.count > 0;
  auto& pass = graph.pass("lighting");
  for (const auto image : {in.rt0, in.rt1, in.rt2, in.depth}) pass.read(image, Access::compute_sample);
  Outputs out{.hdr = pass.write(in.hdr, Access::compute_storage)};
  const auto size = graph.desc(in.hdr);
  const auto list_buffer =
      pass.write(graph.buffer("forward_lists", lists ? list_bytes(size, in.scene.light_ranges.count) : 4),
                 Access::compute_storage);
  if (lists) out.forward_lists = list_buffer;

  auto constants = shading_constants(settings, in.environment);
  constants.insert(constants.end(),
                   {settings.tiled ? 1u : 0u, lists ? 1u : 0u, in.scene.light_ranges.count > 0 ? 1u : 0u});
  pass.run([in, out, list_buffer, size, constants](graph::Context& c) {
    auto with_threads = constants;
    with_threads.push_back(c.tools().device.caps().host_is_device ? kThreadsOnHost : kThreads);
    const auto& pipeline = c.tools().pipelines.compute(kShader, with_threads);
    c.bind(pipeline);
    c.set(pipeline, 0)
        .buffer(0, in.scene.frame)
        .sampled(1, in.rt0, kNearest)
        .sampled(2, in.rt1, kNearest)
        .sampled(3, in.rt2, kNearest)
        .sampled(4, in.depth)
        .stencil(5, in.depth)
        .storage(6, out.hdr)
        .sampled(7, in.environment.background, kEquirect)
        .buffer(8, in.scene.light_bounds)
        .buffer(9, list_buffer)
        .bind();
    c.set(pipeline, 1)
        .sampled(0, in.environment.specular)
        .sampled(1, in.environment.brdf_table)
        .buffer(2, in.scene.lights)
        .sampled(4, in.environment.irradiance)
        .bind();
    c.dispatch(size.width, size.height, upload::kTileSize, upload::kTileSize);
  });
  return out;
}

}  // namespace velarium::lighting
