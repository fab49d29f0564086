#pragma once

#include "graph/graph.hpp"
#include "upload/gpu_scene.hpp"

#include <velarium/settings.hpp>

namespace velarium::lighting {

using Settings = velarium::Settings::lighting_settings;

// Distant light, ready to be sampled.
struct Environment {
  const gpu::Image& background;  // equirectangular; a black texel where there is none
  const gpu::Image& specular;    // cube of pre-convolved levels; black where there is none
  const gpu::Image& irradiance;  // cube of irradiance / pi; black where there is none
  const gpu::Image& brdf_table;  // E0, E1 by (n.v, smoothness), of the model in use
  DiffuseEnvironment diffuse = DiffuseEnvironment::map;
  bool present = false;
};

struct Inputs {
  const upload::SceneTables& scene;
  const Environment& environment;
  graph::GraphImage rt0, rt1, rt2, depth, hdr;
};

struct Outputs {
  graph::GraphImage hdr;             // lit; premultiplied by the coverage in alpha
  graph::GraphBuffer forward_lists;  // bit masks in light order, tile after tile; version 0 where nothing needs them
};

// Lights a tile's list holds at the most. More lights than that are refused by the frame.
[[nodiscard]] Outputs add(graph::Graph& graph, const Inputs& in, const Settings& settings);

// How many constants, from 0 on, upload/frame_lighting.glsl may have; those of a pass of its own follow.
inline constexpr std::size_t kSharedConstants = 20;

// Those constants (0 belongs to the material), which the forward pass shares.
[[nodiscard]] gpu::Specialization shading_constants(const Settings& settings, const Environment& environment);

}  // namespace velarium::lighting
