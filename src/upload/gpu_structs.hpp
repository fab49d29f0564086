#pragma once

#include "shading/host.hpp"

#include <glm/mat4x4.hpp>

namespace velarium::upload {

using glm::mat4;
using glm::vec2;
using glm::vec4;
using shading::GpuLight;
using shading::uint;

#include "upload/gpu_structs.glsl"

}  // namespace velarium::upload
