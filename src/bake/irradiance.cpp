#include "bake/irradiance.hpp"

#include "core/jobs.hpp"
#include "shading/host.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velarium::bake {
namespace {

// Rows of the reduced picture: 2.8 degrees each. The clamped cosine bends at the horizon alone, so that averaging
// radiance over such patches costs less than a thousandth.
constexpr std::uint32_t kReducedRows = 64;

// A patch of sky: its mean direction and the light from it, radiance times solid angle / pi.
struct Patch {
  glm::vec3 direction, power;
};

// Solid angle of one pixel in each row.
std::vector<float> pixel_solid_angles(std::uint32_t width, std::uint32_t height) {
  const double row = std::numbers::pi / height;
  std::vector<float> result(height);
  for (std::uint32_t y = 0; y < height; ++y)
    result[y] = static_cast<float>((std::cos(y * row) - std::cos((y + 1) * row)) * 2.0 * std::numbers::pi / width);
  return result;
}

Patch make_patch(const image::FloatImage& image, const std::vector<float>& solid_angles, glm::uvec2 first,
                 glm::uvec2 last) {
  glm::vec3 direction(0.0f), power(0.0f);
  for (std::uint32_t y = first.y; y < last.y; ++y) {
    for (std::uint32_t x = first.x; x < last.x; ++x) {
      const float* texel = &image.rgba[4 * (std::size_t{y} * image.width + x)];
      const glm::vec2 uv((static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                         (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height));
      direction += shading::equirect_direction(uv) * solid_angles[y];
      power += glm::vec3(texel[0], texel[1], texel[2]) * (solid_angles[y] * shading::kInvPi);
    }
  }
  return {glm::normalize(direction), power};
}

// Each pixel as factor x factor equal ones, so that a pixel is never larger than a patch.
image::FloatImage enlarge(const image::FloatImage& image, std::uint32_t factor) {
  image::FloatImage result{image.width * factor, image.height * factor, {}};
  result.rgba.reserve(std::size_t{4} * result.width * result.height);
  for (std::uint32_t y = 0; y < result.height; ++y) {
    for (std::uint32_t x = 0; x < result.width; ++x) {
      const float* texel = &image.rgba[4 * (std::size_t{y / factor} * image.width + x / factor)];
      result.rgba.insert(result.rgba.end(), texel, texel + 4);
    }
  }
  return result;
}

// The picture in patches of at most 2.8 degrees.
std::vector<Patch> reduce(const image::FloatImage& picture) {
  const std::uint32_t factor = (kReducedRows + picture.height - 1) / picture.height;
  const image::FloatImage enlarged = factor > 1 ? enlarge(picture, factor) : image::FloatImage{};
  const image::FloatImage& image = factor > 1 ? enlarged : picture;
  const auto solid_angles = pixel_solid_angles(image.width, image.height);
  const std::uint32_t rows = kReducedRows, columns = std::min(2 * kReducedRows, image.width);
  std::vector<Patch> patches(std::size_t{rows} * columns);
  parallel_for(rows, [&](std::size_t row) {
    const auto y = static_cast<std::uint32_t>(row);
    for (std::uint32_t x = 0; x < columns; ++x)
      patches[row * columns + x] = make_patch(image, solid_angles, {x * image.width / columns, y * image.height / rows},
                                              {(x + 1) * image.width / columns, (y + 1) * image.height / rows});
  });
  return patches;
}

glm::vec3 gather(const std::vector<Patch>& patches, const glm::vec3& normal) {
  glm::vec3 sum(0.0f);
  for (const auto& patch : patches) sum += patch.power * std::max(glm::dot(patch.direction, normal), 0.0f);
  return sum;
}

}  // namespace

std::vector<glm::vec3> irradiance_cube(const image::FloatImage& equirect, std::uint32_t size) {
  const auto patches = reduce(equirect);
  std::vector<glm::vec3> result(std::size_t{6} * size * size);
  parallel_for(std::size_t{6} * size, [&](std::size_t row) {
    const auto face = static_cast<std::uint32_t>(row / size);
    for (std::uint32_t x = 0; x < size; ++x) {
      const glm::vec2 uv = (glm::vec2(x, row % size) + 0.5f) / static_cast<float>(size);
      result[row * size + x] = gather(patches, shading::cube_direction(face, uv));
    }
  });
  return result;
}

glm::vec3 irradiance(const image::FloatImage& equirect, const glm::vec3& normal) {
  return gather(reduce(equirect), normal);
}

}  // namespace velarium::bake
