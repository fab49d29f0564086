#pragma once

// Light from far away, ready for the device: what is seen directly, what mirrors and rough surfaces reflect, and what
// matt surfaces receive.

#include "gpu/image.hpp"
#include "gpu/gpu_context.hpp"
#include "image/image.hpp"

#include <glm/vec4.hpp>

#include <array>

namespace velarium::bake {

// Irradiance turns slowly: read linearly, 16 texels in 90 degrees err by about a thousandth.
inline constexpr std::uint32_t kIrradianceSize = 16;

struct Environment {
  // The picture itself, equirectangular as in shading/environment.glsl, rgba16f, with all mips; alpha 1.
  gpu::Image background;
  // Cube of 256 pixels a side, rgba16f, kPrefilterLevels mips: level m holds the radiance that a GGX lobe of
  // alpha_from_smoothness(smoothness_of_level(m)), seen head-on, gathers about each direction. Level 0 is the mirror.
  gpu::Image specular;
  // Cube of kIrradianceSize pixels a side, rgba16f: irradiance / pi on a surface that faces each direction.
  gpu::Image irradiance;
  // Integrals of radiance times sh_basis over all directions, for sh_irradiance. w: 0.
  std::array<glm::vec4, 9> sh{};
};

// Radiance above 65504, the largest half, is clamped in the two images, but not in `sh`. Nothing else is: a clamp at a
// thousand times the mean, often used against fireflies, takes up to 46 % of the light from pictures of night streets
// and halls (measured), and the lobes are integrated finely enough to do without. The images are ready to be sampled.
// All but the background is kept on disk, named by the content of the picture. Precondition: values are finite and not
// negative. Throws Error(input_invalid) where the picture is larger than the device's images, Error(temporary) where
// the device fails.
[[nodiscard]] Environment bake_environment(gpu::GpuContext& tools, const image::FloatImage& equirect);

}  // namespace velarium::bake
