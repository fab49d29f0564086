#pragma once

// The C++ reading of the shading maths: velarium::shading::d_ggx(...) is the text that the shaders include.
// The using-declarations are the whole of GLSL that this text may use. The macros of lang.glsl stay defined, so that
// other folders can share their structures in the same way: include this after the headers of other libraries.

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace velarium::shading {

using uint = std::uint32_t;
using glm::mat3;
using glm::mat4;
using glm::uvec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;

using glm::abs;
using glm::acos;
using glm::atan;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp2;
using glm::floatBitsToUint;
using glm::floor;
using glm::fract;
using glm::inversesqrt;
using glm::length;
using glm::log2;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::pow;
using glm::sin;
using glm::sqrt;
using glm::uintBitsToFloat;

[[noreturn]] inline void precondition_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: precondition broken: %s\n", file, line, condition);
  std::abort();
}

#include "shading/ambient_light.glsl"
#include "shading/attenuation.glsl"
#include "shading/brdf.glsl"
#include "shading/cascades.glsl"
#include "shading/clip_volume.glsl"
#include "shading/color.glsl"
#include "shading/constants.glsl"
#include "shading/contact_shadow.glsl"
#include "shading/depth.glsl"
#include "shading/diffuse.glsl"
#include "shading/display.glsl"
#include "shading/environment.glsl"
#include "shading/gbuffer.glsl"
#include "shading/light_volumes.glsl"
#include "shading/lights.glsl"
#include "shading/microfacet.glsl"
#include "shading/normal_encoding.glsl"
#include "shading/specular_aa.glsl"
#include "shading/projector.glsl"
#include "shading/sampling.glsl"
#include "shading/shadow_atlas.glsl"
#include "shading/shadow_bias.glsl"
#include "shading/shadow_filter.glsl"
#include "shading/smoothness.glsl"
#include "shading/specular_encoding.glsl"
#include "shading/area_lights.glsl"
#include "shading/surface.glsl"
#include "shading/tile_culling.glsl"
#include "shading/tonemap.glsl"
#include "shading/translucency.glsl"
#include "shading/variance_shadow.glsl"

}  // namespace velarium::shading
