#include "image/exr_light.hpp"

#include "core/jobs.hpp"
#include "image/codecs.hpp"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <ImfChromaticities.h>
#include <ImfEnvmap.h>
#include <ImfStandardAttributes.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace velarium::image {
namespace {

glm::dvec3 xyz_of(const Imath::V2f& chromaticity) {
  const double x = chromaticity.x, y = chromaticity.y;
  return {x / y, 1.0, (1.0 - x - y) / y};
}

// Columns: the primaries, in such amounts that together they make the white [SMPTE RP 177-1993].
glm::dmat3 xyz_from_rgb(const Imf::Chromaticities& c) {
  const glm::dmat3 primaries(xyz_of(c.red), xyz_of(c.green), xyz_of(c.blue));
  const glm::dvec3 amounts = glm::inverse(primaries) * xyz_of(c.white);
  return {primaries[0] * amounts.x, primaries[1] * amounts.y, primaries[2] * amounts.z};
}

// G. Hunt, R. Pointer: "Measuring Colour" (2011), Bradford's cone responses.
glm::dmat3 adaptation(const glm::dvec3& from_white, const glm::dvec3& to_white) {
  const glm::dmat3 cones =
      glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
  const glm::dvec3 scale = (cones * to_white) / (cones * from_white);
  return glm::inverse(cones) * glm::dmat3(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z) * cones;
}

bool is_plausible(const Imf::Chromaticities& c) {
  for (const Imath::V2f& p : {c.red, c.green, c.blue, c.white})
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !(std::abs(p.y) > 1e-3f)) return false;
  return std::abs(glm::determinant(glm::dmat3(xyz_of(c.red), xyz_of(c.green), xyz_of(c.blue)))) > 1e-6;
}

// Directions of the panorama's pixels, as docs/conventions.md has them.
glm::vec3 direction_at(std::uint32_t x, std::uint32_t y, Size size) {
  const float azimuth =
      ((static_cast<float>(x) + 0.5f) / static_cast<float>(size.width) - 0.5f) * 2.0f * std::numbers::pi_v<float>;
  const float polar = (static_cast<float>(y) + 0.5f) / static_cast<float>(size.height) * std::numbers::pi_v<float>;
  return {std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)};
}

// Bilinear within the face that the direction meets.
glm::vec4 cube_at(const FloatImage& cube, const glm::vec3& direction) {
  const Imath::Box2i all({0, 0}, {static_cast<int>(cube.width) - 1, static_cast<int>(cube.height) - 1});
  Imf::CubeMapFace face{};
  Imath::V2f in_face;
  Imf::CubeMap::faceAndPixelPosition({direction.x, direction.y, direction.z}, all, face, in_face);
  const Imath::V2f place = Imf::CubeMap::pixelPosition(face, all, in_face);
  const Imath::Box2i window = Imf::CubeMap::dataWindowForFace(face, all);
  const auto texel = [&](int x, int y) {
    x = std::clamp(x, window.min.x, window.max.x);
    y = std::clamp(y, window.min.y, window.max.y);
    const float* p = cube.rgba.data() + 4 * (static_cast<std::size_t>(y) * cube.width + static_cast<std::size_t>(x));
    return glm::vec4(p[0], p[1], p[2], p[3]);
  };
  const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
  const float u = place.x - static_cast<float>(x), v = place.y - static_cast<float>(y);
  return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), u), glm::mix(texel(x, y + 1), texel(x + 1, y + 1), u), v);
}

}  // namespace

void convert_to_bt709(const Imf::Header& header, FloatImage& image) {
  if (!Imf::hasChromaticities(header) || !is_plausible(Imf::chromaticities(header))) return;
  const Imf::Chromaticities& from = Imf::chromaticities(header);
  const Imf::Chromaticities to;  // BT.709's
  if (from == to) return;
  const glm::mat3 matrix(glm::inverse(xyz_from_rgb(to)) * adaptation(xyz_of(from.white), xyz_of(to.white)) *
                         xyz_from_rgb(from));
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    // Colours outside BT.709 have negative parts, which no light of this program has.
    const glm::vec3 rgb =
        glm::max(matrix * glm::vec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]), glm::vec3(0.0f));
    for (int c = 0; c < 3; ++c) image.rgba[i + static_cast<std::size_t>(c)] = rgb[c];
  }
}

FloatImage panorama_of(const Imf::Header& header, FloatImage image, const std::string& what, const Limits& limits) {
  if (!Imf::hasEnvmap(header) || Imf::envmap(header) != Imf::ENVMAP_CUBE) return image;
  if (std::uint64_t{6} * image.width != image.height)
    invalid(what, fmt::format("OpenEXR: a cube of {} x {} pixels; six square faces stand one below the other",
                              image.width, image.height));
  const Size size{4 * image.width, 2 * image.width};
  check_size(size, what, limits);
  FloatImage panorama{size.width, size.height, std::vector<float>(channel_count(size))};
  parallel_for(size.height, [&](std::size_t y) {
    for (std::uint32_t x = 0; x < size.width; ++x) {
      const glm::vec4 value = cube_at(image, direction_at(x, static_cast<std::uint32_t>(y), size));
      for (int c = 0; c < 4; ++c) panorama.rgba[4 * (y * size.width + x) + static_cast<std::size_t>(c)] = value[c];
    }
  });
  return panorama;
}

}  // namespace velarium::image
