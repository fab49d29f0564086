#include "bake/environment_sh.hpp"

#include "core/jobs.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace velarium::bake {
namespace {

using Coefficients = std::array<glm::dvec3, 9>;

constexpr double kPi = std::numbers::pi;

// Integrals over one row of pixels, polar angle a to b, of what the basis functions have in the polar angle t.
// The names list the factors, s = sin t, c = cos t; one s of each is that of the solid angle.
struct PolarIntegrals {
  double s, sc, scc, ss, ssc, sss;
};

PolarIntegrals integrate_polar(double a, double b) {
  const double sin_a = std::sin(a), cos_a = std::cos(a), sin_b = std::sin(b), cos_b = std::cos(b);
  const auto cube = [](double x) { return x * x * x; };
  const double s = cos_a - cos_b;
  const double scc = (cube(cos_a) - cube(cos_b)) / 3.0;
  return {.s = s,
          .sc = 0.5 * (sin_b * sin_b - sin_a * sin_a),
          .scc = scc,
          .ss = 0.5 * (b - a) - 0.5 * (sin_b * cos_b - sin_a * cos_a),
          .ssc = (cube(sin_b) - cube(sin_a)) / 3.0,
          .sss = s - scc};
}

// The same for the azimuth: radiance of one row against 1, cos, sin, cos of the double angle, sin of it.
struct AzimuthIntegrals {
  glm::dvec3 one{}, cos1{}, sin1{}, cos2{}, sin2{};
};

// Cosine and sine of the azimuth at each column's centre.
std::vector<glm::dvec2> column_directions(std::uint32_t width) {
  std::vector<glm::dvec2> directions(width);
  for (std::uint32_t x = 0; x < width; ++x) {
    const double azimuth = ((x + 0.5) / width - 0.5) * 2.0 * kPi;
    directions[x] = {std::cos(azimuth), std::sin(azimuth)};
  }
  return directions;
}

AzimuthIntegrals integrate_row(const float* rgba, const std::vector<glm::dvec2>& columns) {
  AzimuthIntegrals sum;
  for (const auto& column : columns) {
    const glm::dvec3 radiance(rgba[0], rgba[1], rgba[2]);
    sum.one += radiance;
    sum.cos1 += radiance * column.x;
    sum.sin1 += radiance * column.y;
    sum.cos2 += radiance * (column.x * column.x - column.y * column.y);
    sum.sin2 += radiance * (2.0 * column.x * column.y);
    rgba += 4;
  }
  // A column's integral of cos(k azimuth) is its value at the centre times 2 sin(k step / 2) / k.
  const double step = 2.0 * kPi / static_cast<double>(columns.size());
  const double first = 2.0 * std::sin(0.5 * step), second = std::sin(step);
  return {sum.one * step, sum.cos1 * first, sum.sin1 * first, sum.cos2 * second, sum.sin2 * second};
}

// x = sin t cos p, y = cos t, z = sin t sin p, in the order and with the factors of sh_basis.
Coefficients combine(const PolarIntegrals& polar, const AzimuthIntegrals& azimuth) {
  const double band0 = std::sqrt(1.0 / (4.0 * kPi));
  const double band1 = std::sqrt(3.0 / (4.0 * kPi));
  const double band2 = std::sqrt(15.0 / (4.0 * kPi));
  const glm::dvec3 zz = 0.5 * polar.sss * (azimuth.one - azimuth.cos2);
  const glm::dvec3 xx = 0.5 * polar.sss * (azimuth.one + azimuth.cos2);
  return {band0 * polar.s * azimuth.one,
          band1 * polar.sc * azimuth.one,
          band1 * polar.ss * azimuth.sin1,
          band1 * polar.ss * azimuth.cos1,
          band2 * polar.ssc * azimuth.cos1,
          band2 * polar.ssc * azimuth.sin1,
          band2 / std::sqrt(12.0) * (3.0 * zz - polar.s * azimuth.one),
          band2 * 0.5 * polar.sss * azimuth.sin2,
          band2 * 0.5 * (xx - polar.scc * azimuth.one)};
}

}  // namespace

std::array<glm::vec4, 9> project_sh(const image::FloatImage& equirect) {
  const auto columns = column_directions(equirect.width);
  std::vector<Coefficients> rows(equirect.height);
  parallel_for(equirect.height, [&](std::size_t y) {
    const double step = kPi / equirect.height;
    const auto polar = integrate_polar(static_cast<double>(y) * step, static_cast<double>(y + 1) * step);
    rows[y] = combine(polar, integrate_row(&equirect.rgba[4 * y * equirect.width], columns));
  });
  Coefficients sum{};
  for (const auto& row : rows)
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += row[i];
  std::array<glm::vec4, 9> result;
  for (std::size_t i = 0; i < sum.size(); ++i) result[i] = glm::vec4(glm::vec3(sum[i]), 0.0f);
  return result;
}

}  // namespace velarium::bake
