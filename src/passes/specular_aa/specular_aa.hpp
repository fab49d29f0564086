#pragma once

#include "passes/frame_scene.hpp"
#include "passes/gbuffer/read.hpp"

#include <velarium/settings.hpp>

namespace velarium::specular_aa {

using Settings = velarium::Settings::specular_aa_settings;

struct Inputs {
  passes::FrameScene scene;
  gbuffer::Reading gbuffer;
};

// Widens the lobes of smooth surfaces whose normals differ from pixel to pixel. Returns gbuffer.specular with the
// smoothness and the luma of f0 that are left; adds no pass where settings.screen is off.
[[nodiscard]] graph::GraphImage add(graph::Graph& graph, const Inputs& in, const Settings& settings);

}  // namespace velarium::specular_aa
