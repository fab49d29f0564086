#pragma once

// What passes that shade by upload/frame_lighting.glsl have in common: what it reads in descriptor set 1, and how it is
// specialised. A technique that shades through that file adds its images here, and none of those passes changes.

#include "passes/sun_map.hpp"

namespace velarium::passes {

// Distant light, ready to be sampled.
struct Environment {
  const gpu::Image& background;  // equirectangular; a black texel where there is none
  const gpu::Image& specular;    // cube of pre-convolved levels; black where there is none
  const gpu::Image& irradiance;  // cube of irradiance / pi; black where there is none
  const gpu::Image& brdf_table;  // E0, E1 by (n.v, smoothness), of the model in use
  DiffuseEnvironment diffuse = DiffuseEnvironment::map;
  bool present = false;
};

// Everything outlives the frame. Handles of version 0: this picture has no such thing.
struct ShadingInputs {
  const upload::SceneTables& scene;
  const Environment& environment;
  const Settings& settings;
  const gpu::Image& no_map;        // of depth: bound, and never read, where a map is missing
  graph::GraphImage shadow_atlas;  // depth of point and spot lights' views
  graph::GraphImage sun_cascades;  // depth, a layer a cascade; always there, of one texel where there is no sun
  FarSunMap sun_far;               // beyond the cascades
  graph::GraphImage sun_mask;      // of opaque surfaces: what share of the sun is hidden
  graph::GraphImage shadow_veils;  // beside the atlas, and beside the cascades: what BLEND surfaces leave of light,
  graph::GraphImage sun_veils;     // shading/translucency.glsl
};

// Opaque surfaces: shading/gbuffer.glsl, read through upload/gbuffer_point.glsl.
struct GBuffer {
  graph::GraphImage rt0, rt1, rt2;
  graph::GraphImage depth;  // and the material class in the stencil
};

// How many constants, from 0 on, upload/frame_lighting.glsl may have; those of a pass of its own follow.
inline constexpr std::size_t kSharedConstants = 20;

// Those constants; 0 belongs to the material.
[[nodiscard]] gpu::Specialization shading_constants(const ShadingInputs& in);

// Those of upload/contact_shadows.glsl: 10, 16, 18 and 19.
void set_contact_shadows(const Settings::contact_shadows_settings& contact, gpu::Specialization& constants);

// Declares that a pass reads, in this way, what earlier passes made of these.
void read(graph::Pass& pass, const ShadingInputs& in, graph::Access access);
void read(graph::Pass& pass, const GBuffer& in, graph::Access access);

// Adds everything to a pass's set 1, but for binding 3, its light lists.
void bind(graph::SetWriter& set, const ShadingInputs& in);
// Adds bindings 1 to 5 to a pass's set 0.
void bind(graph::SetWriter& set, const GBuffer& in);

}  // namespace velarium::passes
