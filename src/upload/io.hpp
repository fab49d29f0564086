#pragma once

#include "gpu/slot.hpp"
#include "upload/gpu_structs.hpp"

namespace velarium::upload::io {

#include "upload/frame_io.glsl"
#include "upload/lights_io.glsl"
#include "upload/material_io.glsl"
#include "upload/objects_io.glsl"

}  // namespace velarium::upload::io
