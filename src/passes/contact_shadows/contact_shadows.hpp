#pragma once

#include "passes/contact_shadows/read.hpp"

#include <velarium/settings.hpp>

namespace velarium::contact_shadows {

using Settings = velarium::Settings::contact_shadows_settings;

// For passes that look for shadows of the sun, or of other lights.
struct Readings {
  Reading sun, local;
};

// any_local_map: has some point or spot light a map that contact shadows could refine?
[[nodiscard]] Readings add(graph::Graph& graph, bool any_local_map, const Settings& settings);

}  // namespace velarium::contact_shadows
