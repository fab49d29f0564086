#include "bake/environment_texels.hpp"

#include "core/jobs.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "shading/host.hpp"

namespace velarium::bake {
namespace {

constexpr std::uint16_t kHalfOne = 0x3c00;

void append_halves(const image::FloatImage& image, std::vector<std::uint16_t>& out) {
  const std::size_t begin = out.size(), row = 4 * static_cast<std::size_t>(image.width);
  out.resize(begin + row * image.height);
  parallel_for(image.height, [&](std::size_t y) {
    const float* from = &image.rgba[y * row];
    std::uint16_t* to = &out[begin + y * row];
    for (std::size_t i = 0; i < row; ++i)
      to[i] = i % 4 == 3 ? kHalfOne : half_from_float(std::min(from[i], shading::kLargestHalf));
  });
}

// The part of the source pixels that one pixel covers when `from` of them become `to`, and how much of each.
struct Coverage {
  std::uint32_t first = 0;
  std::vector<float> weights;
};

Coverage cover(std::uint32_t pixel, std::uint32_t from, std::uint32_t to) {
  const double begin = static_cast<double>(pixel) * from / to, end = static_cast<double>(pixel + 1) * from / to;
  Coverage coverage{static_cast<std::uint32_t>(begin), {}};
  for (std::uint32_t i = coverage.first; i < from && i < end; ++i)
    coverage.weights.push_back(static_cast<float>(std::min(end, i + 1.0) - std::max(begin, static_cast<double>(i))));
  return coverage;
}

// Solid angle of a row of pixels, but for a factor.
float row_weight(std::uint32_t y, std::uint32_t height) {
  const double step = std::numbers::pi / height;
  return static_cast<float>(std::cos(y * step) - std::cos((y + 1) * step));
}

glm::vec3 mean(const image::FloatImage& image, const Coverage& columns, const Coverage& rows) {
  glm::vec3 sum(0.0f);
  float weight_sum = 0.0f;
  for (std::uint32_t y = 0; y < rows.weights.size(); ++y)
    for (std::uint32_t x = 0; x < columns.weights.size(); ++x) {
      const float weight = rows.weights[y] * columns.weights[x];
      const float* p = &image.rgba[4 * (std::size_t{rows.first + y} * image.width + columns.first + x)];
      sum += weight * glm::vec3(p[0], p[1], p[2]);
      weight_sum += weight;
    }
  return sum / weight_sum;
}

image::FloatImage halve(const image::FloatImage& source) {
  image::FloatImage result{.width = std::max(source.width / 2, 1u), .height = std::max(source.height / 2, 1u)};
  result.rgba.resize(4 * static_cast<std::size_t>(result.width) * result.height, 1.0f);
  std::vector<Coverage> columns;
  for (std::uint32_t x = 0; x < result.width; ++x) columns.push_back(cover(x, source.width, result.width));
  parallel_for(result.height, [&](std::size_t y) {
    auto rows = cover(static_cast<std::uint32_t>(y), source.height, result.height);
    for (std::uint32_t i = 0; i < rows.weights.size(); ++i)
      rows.weights[i] *= row_weight(rows.first + i, source.height);
    float* out = &result.rgba[4 * y * result.width];
    for (const auto& column : columns) {
      const glm::vec3 value = mean(source, column, rows);
      std::copy_n(&value.x, 3, out);
      out += 4;
    }
  });
  return result;
}

}  // namespace

std::vector<std::uint16_t> half_mips(const image::FloatImage& equirect) {
  std::vector<std::uint16_t> halves;
  append_halves(equirect, halves);
  if (std::max(equirect.width, equirect.height) == 1) return halves;
  image::FloatImage mip = halve(equirect);
  append_halves(mip, halves);
  while (std::max(mip.width, mip.height) > 1) {
    mip = halve(mip);
    append_halves(mip, halves);
  }
  return halves;
}

}  // namespace velarium::bake
