#include "reference/environment_light.hpp"

#include "core/assert.hpp"
#include "core/jobs.hpp"
#include "shading/host.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace velarium::reference {
namespace {

// Cosines of the polar angles between rows, from the top pole to the other: in double, since near the poles a float's
// cosines stand still.
std::vector<double> cosines_between_rows(std::uint32_t height) {
  std::vector<double> cosines(height + 1);
  for (std::uint32_t y = 0; y <= height; ++y) cosines[y] = std::cos(y * std::numbers::pi / height);
  return cosines;
}

glm::vec3 texel(const image::FloatImage& image, std::uint32_t x, std::uint32_t y) {
  const float* p = &image.rgba[4 * (std::size_t{y} * image.width + x)];
  return {p[0], p[1], p[2]};
}

double texel_luminance(const image::FloatImage& image, std::uint32_t x, std::uint32_t y) {
  return shading::luminance(texel(image, x, y));
}

// Mean over the unit square of the square of what interpolates four corners; a and d are opposite.
double mean_square_of_bilinear(double a, double b, double c, double d) {
  return (a * a + b * b + c * c + d * d + (a + d) * (b + c)) / 9.0 + (a * d + b * c) / 18.0;
}

// Root of the mean square of the luminance that is read inside one pixel: each quarter of it is interpolated between
// the pixel, two of its neighbours and the one between them.
double root_mean_square(const image::FloatImage& image, std::uint32_t x, std::uint32_t y) {
  const std::uint32_t left = (x + image.width - 1) % image.width, right = (x + 1) % image.width;
  const std::uint32_t above = y > 0 ? y - 1 : 0, below = std::min(y + 1, image.height - 1);
  const double middle = texel_luminance(image, x, y);
  double sum = 0.0;
  for (const std::uint32_t column : {left, right}) {
    for (const std::uint32_t row : {above, below}) {
      const double beside = texel_luminance(image, column, y), over = texel_luminance(image, x, row);
      const double diagonal = texel_luminance(image, column, row);
      sum += mean_square_of_bilinear(middle, 0.5 * (middle + beside), 0.5 * (middle + over),
                                     0.25 * (middle + beside + over + diagonal));
    }
  }
  return std::sqrt(0.25 * sum);
}

// Weights of pixels; none where the light is switched off.
Distribution2d distribute(const image::FloatImage& image, const std::vector<double>& cosines, float intensity) {
  VEL_ASSERT(image.width > 0 && image.height > 0 && intensity >= 0.0f);
  std::vector<float> weights(std::size_t{image.width} * image.height);
  if (intensity > 0.0f) {
    parallel_for(image.height, [&](std::size_t row) {
      const auto y = static_cast<std::uint32_t>(row);
      const double height = cosines[row] - cosines[row + 1];  // in proportion to the solid angle
      for (std::uint32_t x = 0; x < image.width; ++x)
        weights[row * image.width + x] = static_cast<float>(root_mean_square(image, x, y) * height);
    });
  }
  return Distribution2d(weights, image.width, image.height);
}

}  // namespace

EnvironmentLight::EnvironmentLight(image::FloatImage lat_long, float rotation_deg, float intensity)
    : image_(std::move(lat_long)),
      cos_rotation_(std::cos(glm::radians(rotation_deg))),
      sin_rotation_(std::sin(glm::radians(rotation_deg))),
      intensity_(intensity),
      row_cosines_(cosines_between_rows(image_.height)),
      pixels_(distribute(image_, row_cosines_, intensity)) {}

glm::vec3 EnvironmentLight::to_environment(const glm::vec3& d) const {
  return shading::turned_to_environment(d, cos_rotation_, sin_rotation_);
}

glm::vec3 EnvironmentLight::to_world(const glm::vec3& d) const {
  return {cos_rotation_ * d.x + sin_rotation_ * d.z, d.y, cos_rotation_ * d.z - sin_rotation_ * d.x};
}

// The density of pixels_ covers a square; this is the solid angle of the same share of the sphere, row by row.
float EnvironmentLight::pdf_sr_of(float pdf_square, std::uint32_t row) const {
  const double square_sr = (row_cosines_[row] - row_cosines_[row + 1]) * 2.0 * std::numbers::pi * image_.height;
  return pdf_square / static_cast<float>(square_sr);
}

glm::vec3 EnvironmentLight::read(const glm::vec2& uv) const {
  // Place among the pixels' centres. Columns go around, rows end at the poles.
  const float x = uv.x * static_cast<float>(image_.width) - 0.5f;
  const float y =
      std::clamp(uv.y * static_cast<float>(image_.height) - 0.5f, 0.0f, static_cast<float>(image_.height - 1));
  const float fx = x - std::floor(x), fy = y - std::floor(y);
  const auto left = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(x)) + image_.width) % image_.width;
  const auto above = static_cast<std::uint32_t>(y);
  const std::uint32_t right = (left + 1) % image_.width, below = std::min(above + 1, image_.height - 1);
  const glm::vec3 upper = glm::mix(texel(image_, left, above), texel(image_, right, above), fx);
  const glm::vec3 lower = glm::mix(texel(image_, left, below), texel(image_, right, below), fx);
  return glm::mix(upper, lower, fy);
}

glm::vec3 EnvironmentLight::radiance(const glm::vec3& direction_ws) const {
  return intensity_ * read(shading::equirect_uv(to_environment(direction_ws)));
}

EnvironmentLight::Sample EnvironmentLight::sample(const glm::vec2& u) const {
  const Distribution2d::Sample chosen = pixels_.sample(u);
  // Within the pixel even in solid angle, not in the picture: even in the cosine of the polar angle.
  const double begin = row_cosines_[chosen.cell.y], end = row_cosines_[chosen.cell.y + 1];
  const double offset = static_cast<double>(chosen.uv.y) * image_.height - chosen.cell.y;
  const double cosine = begin + offset * (end - begin);
  const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
  const float azimuth = (chosen.uv.x - 0.5f) * shading::kTwoPi;
  const glm::vec3 d(static_cast<float>(sine) * std::cos(azimuth), cosine, static_cast<float>(sine) * std::sin(azimuth));
  return {to_world(d), intensity_ * read(shading::equirect_uv(d)), pdf_sr_of(chosen.pdf, chosen.cell.y)};
}

float EnvironmentLight::pdf_sr(const glm::vec3& wi) const {
  const glm::vec2 uv = shading::equirect_uv(to_environment(wi));
  const auto row = std::min(static_cast<std::uint32_t>(uv.y * static_cast<float>(image_.height)), image_.height - 1);
  return pdf_sr_of(pixels_.pdf(uv), row);
}

}  // namespace velarium::reference
