#pragma once

// What a NAME_io.glsl needs where C++ reads it: include this, then the file in a namespace `io` of its technique that
// uses namespace shading.

#include "gpu/slot.hpp"
#include "graph/context.hpp"
#include "shading/host.hpp"
