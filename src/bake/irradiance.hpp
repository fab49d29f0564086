#pragma once

#include "image/image.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace velarium::bake {

// Irradiance / pi on a surface facing each texel of a cube map: the mean radiance that an albedo multiplies. Faces of
// size x size texels in the order and orientation of shading/environment.glsl, rows from the top.
//
// Spherical harmonics of band 2 miss it by 2 to 9 % (root mean square over directions, measured on studio, hall and
// sunset pictures), because bright lights make the clamped cosine's higher bands visible; this map, read linearly, by
// 0.2 % at size 16.
[[nodiscard]] std::vector<glm::vec3> irradiance_cube(const image::FloatImage& equirect, std::uint32_t size);

// The same for one unit normal.
[[nodiscard]] glm::vec3 irradiance(const image::FloatImage& equirect, const glm::vec3& normal);

}  // namespace velarium::bake
