#pragma once

#include "passes/contact_shadows/read.hpp"
#include "passes/gbuffer/read.hpp"
#include "passes/illumination.hpp"

namespace velarium::lighting {

struct Inputs {
  passes::Illumination illumination;
  contact_shadows::Reading contact;
  gbuffer::Reading gbuffer;
  graph::GraphImage hdr;  // emissive light
  LightingPath path = LightingPath::tiled;
  graph::GraphImage volume_light;  // of LightingPath::volumes: what all lights reflect; version 0: none is seen
};

struct Outputs {
  graph::GraphImage hdr;             // lit; premultiplied by the coverage in alpha
  graph::GraphBuffer forward_lists;  // bit masks in light order, tile after tile; version 0 where nothing needs them
};

[[nodiscard]] Outputs add(graph::Graph& graph, const Inputs& in);

}  // namespace velarium::lighting
