#include "passes/shading_inputs.hpp"

#include <bit>

namespace velarium::passes {
namespace {

// Constants 8, 11 and 14: what lamps there are, and how narrow their highlights may be.
void set_lamps(const ShadingInputs& in, gpu::Specialization& constants) {
  const auto& lighting = in.settings.lighting;
  constants[8] = in.scene.light_ranges.projectors ? 1u : 0u;
  constants[11] = lighting.sphere_highlights && in.scene.light_ranges.sized ? 1u : 0u;
  constants[14] = std::bit_cast<std::uint32_t>(lighting.min_highlight_alpha);
}

// The atlas as plain depth, as comparisons, and the table of what it holds: upload/local_shadows.glsl.
void bind_local_shadows(graph::SetWriter& set, const ShadingInputs& in) {
  if (in.shadow_atlas.version == 0) {
    set.sampled(5, in.no_map, gpu::kNearest).sampled(6, in.no_map, {.compare = true}).buffer(7, in.scene.lights);
    return;
  }
  set.sampled(5, in.shadow_atlas).sampled(6, in.shadow_atlas, {.compare = true}).buffer(7, in.scene.shadow_views);
}

// The mask for opaque surfaces, and for transparent ones the cascades: upload/sun_shadows.glsl.
void bind_sun_shadows(graph::SetWriter& set, const ShadingInputs& in) {
  set.sampled(9, in.sun_cascades).sampled(10, in.sun_cascades, {.compare = true}).buffer(11, in.scene.sun_shadows);
  bind(set, in.sun_far, in.sun_cascades);
  if (in.sun_mask.version != 0)
    set.sampled(8, in.sun_mask, gpu::kNearest);
  else
    set.sampled(8, in.environment.background);
}

// upload/local_veils.glsl, upload/sun_veils.glsl. Where there are none, an array is bound and never read.
void bind_veils(graph::SetWriter& set, const ShadingInputs& in) {
  const gpu::Image& none = in.scene.gpu->projectors().array;
  if (in.shadow_veils.version != 0)
    set.sampled(14, in.shadow_veils, gpu::kNearest);
  else
    set.sampled(14, none);
  if (in.sun_veils.version != 0)
    set.sampled(15, in.sun_veils, gpu::kNearest);
  else
    set.sampled(15, none);
}

// Constant 7: upload/local_shadows.glsl.
std::uint32_t soft_taps(const ShadingInputs& in) {
  if (in.shadow_atlas.version == 0) return 0;
  return in.scene.light_ranges.sized ? static_cast<std::uint32_t>(in.settings.local_shadows.taps) : 1;
}

}  // namespace

void set_contact_shadows(const Settings::contact_shadows_settings& contact, gpu::Specialization& constants) {
  if (!contact.enabled) return;
  constants[10] = static_cast<std::uint32_t>(contact.steps);
  constants[16] = contact.without_map ? 1u : 0u;
  constants[18] = std::bit_cast<std::uint32_t>(contact.length);
  constants[19] = std::bit_cast<std::uint32_t>(contact.thickness);
}

gpu::Specialization shading_constants(const ShadingInputs& in) {
  const auto& lighting = in.settings.lighting;
  const bool multi_scatter = lighting.multi_scatter && lighting.model == ShadingModel::gltf;
  gpu::Specialization constants(kSharedConstants);
  constants[1] = static_cast<std::uint32_t>(lighting.model);
  constants[2] = multi_scatter ? 1u : 0u;
  constants[3] = lighting.occlusion ? 1u : 0u;
  constants[4] = in.environment.present ? 1u : 0u;
  constants[5] = in.environment.diffuse == DiffuseEnvironment::sh ? 1u : 0u;
  constants[7] = soft_taps(in);
  set_lamps(in, constants);
  constants[9] = in.scene.clip_volumes ? 1u : 0u;
  const auto& contact = in.settings.contact_shadows;
  if (in.shadow_atlas.version != 0 || contact.without_map) set_contact_shadows(contact, constants);
  constants[6] = in.sun_mask.version != 0 ? 1u : 0u;
  constants[15] = static_cast<std::uint32_t>(in.sun_far.kind);
  constants[12] = (in.sun_veils.version != 0 ? 1u : 0u) | (in.shadow_veils.version != 0 ? 2u : 0u);
  constants[13] = static_cast<std::uint32_t>(in.settings.sun_shadows.taps);
  return constants;
}

void read(graph::Pass& pass, const ShadingInputs& in, graph::Access access) {
  for (const auto image :
       {in.shadow_atlas, in.shadow_veils, in.sun_cascades, in.sun_far.image, in.sun_veils, in.sun_mask})
    if (image.version != 0) pass.read(image, access);
}

void read(graph::Pass& pass, const GBuffer& in, graph::Access access) {
  for (const auto image : {in.rt0, in.rt1, in.rt2, in.depth}) pass.read(image, access);
}

void bind(graph::SetWriter& set, const ShadingInputs& in) {
  set.sampled(0, in.environment.specular)
      .sampled(1, in.environment.brdf_table)
      .buffer(2, in.scene.lights)
      .sampled(4, in.environment.irradiance)
      .sampled(12, in.scene.gpu->projectors().array, {.lod_bias = in.scene.texture_lod_bias})
      // Where there are none, something is bound and never read.
      .buffer(13, in.scene.clip_volumes ? in.scene.clip_volumes : in.scene.lights);
  bind_local_shadows(set, in);
  bind_sun_shadows(set, in);
  bind_veils(set, in);
}

void bind(graph::SetWriter& set, const GBuffer& in) {
  set.sampled(1, in.rt0, gpu::kNearest)
      .sampled(2, in.rt1, gpu::kNearest)
      .sampled(3, in.rt2, gpu::kNearest)
      .sampled(4, in.depth)
      .stencil(5, in.depth);
}

}  // namespace velarium::passes
