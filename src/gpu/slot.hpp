#pragma once

// Names of what shaders bind and specialise, as C++ reads them from the shaders' own NAME_io.glsl (shading/lang.glsl).

#include <cstdint>

namespace velarium::gpu {

inline constexpr std::uint32_t kPushConstantBytes = 128;  // all that the poorest driver has

// What a binding takes, in the words of GLSL; depth_: of an image of depth.
enum class SlotType {
  texture2D,
  texture2DArray,
  textureCube,
  textureCubeArray,
  texture3D,
  utexture2D,
  depth_texture2D,
  depth_texture2DArray,
  sampler2D,  // images with a sampler of their own
  sampler2DArray,
  samplerCube,
  sampler,
  samplerShadow,
  storage_image,
  buffer
};

// A binding of a descriptor set.
struct Slot {
  std::uint32_t set = 0, binding = 0;
  SlotType type = SlotType::buffer;
};

// A specialisation constant. T: uint, int, float or bool.
template <class T>
struct Constant {
  std::uint32_t id = 0;
};

}  // namespace velarium::gpu
