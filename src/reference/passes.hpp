#pragma once

#include "reference/tracer.hpp"

namespace velarium::reference {

// Traces paths until the settings' number, time or noise is reached, or on_progress says no. Fills the film,
// `finished`, `seconds`, `threads` and `paths` of the result.
//
// Threads take tiles; the paths of a pixel are added in their order, so that the number of threads changes nothing.
void trace_passes(const PathTracer& tracer, const Settings::reference_settings& settings,
                  const std::function<bool(const Progress&)>& on_progress, Result& result);

}  // namespace velarium::reference
