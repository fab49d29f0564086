#pragma once

#include "passes/far_shadows/state.hpp"
#include "passes/local_shadows/state.hpp"
#include "passes/sun_shadows/state.hpp"

namespace velarium::frame {

// What outlives the frames of a view: a member a technique that keeps something.
struct State {
  sun_shadows::State sun_shadows;
  far_shadows::State far_shadows;
  local_shadows::State local_shadows;
};

}  // namespace velarium::frame
