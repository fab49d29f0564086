#include "bake/environment_lobe.hpp"

#include "shading/host.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velarium::bake {
namespace {

constexpr double kPi = std::numbers::pi;

// Midpoint steps across a ring. The lobe changes by a few times over the widest ring: 32 leave an error of 1e-3 of it.
constexpr int kSteps = 32;

struct Ring {
  double begin, end;      // angle from the axis
  double integral = 0.0;  // of D cos sin over the angle
  double centroid = 0.0;  // mean angle under it
};

Ring integrate_ring(double begin, double end, float alpha) {
  Ring ring{begin, end};
  const double step = (end - begin) / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = begin + (i + 0.5) * step;
    const double sin_half = std::sin(0.5 * angle);
    const double d = static_cast<double>(shading::d_ggx_from_sin2(static_cast<float>(sin_half * sin_half), alpha));
    const double value = d * std::cos(angle) * std::sin(angle) * step;
    ring.integral += value;
    ring.centroid += value * angle;
  }
  ring.centroid /= ring.integral;
  return ring;
}

void append_cells(const Ring& ring, std::uint32_t index, double texel, std::vector<LobeSample>& samples) {
  const double width = ring.end - ring.begin;
  const double around = 2.0 * kPi * std::sin(0.5 * (ring.begin + ring.end)) / width;
  const bool axis = ring.begin == 0.0;
  const int count = axis ? 1 : std::max(static_cast<int>(std::ceil(around)), 4);
  const double size = std::sqrt(2.0 * kPi * (std::cos(ring.begin) - std::cos(ring.end)) / count);
  const double radius = axis ? 0.0 : std::sin(ring.centroid);
  // Rings are turned against each other by the golden angle, so that cells do not line up.
  const double turn = index * kPi * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < count; ++i) {
    const double angle = turn + 2.0 * kPi * i / count;
    samples.push_back({.x = static_cast<float>(radius * std::cos(angle)),
                       .y = static_cast<float>(radius * std::sin(angle)),
                       .source_lod = static_cast<float>(std::max(std::log2(size / texel), 0.0)),
                       .weight = static_cast<float>(ring.integral / count)});
  }
}

}  // namespace

std::vector<LobeSample> cut_lobe(float alpha, const LobeGrid& grid, float face_size) {
  // D falls to half where tan(theta_h) = alpha sqrt(sqrt(2) - 1), and the light's angle is twice that.
  const double half_width = 2.0 * std::atan(alpha * std::sqrt(std::numbers::sqrt2 - 1.0));
  const double core = grid.core * half_width;
  const double texel = std::sqrt(4.0 * kPi / 6.0) / face_size;
  std::vector<LobeSample> samples;
  double begin = 0.0, end = 0.5 * core, sum = 0.0;
  for (std::uint32_t index = 0; begin < 0.5 * kPi; ++index) {
    if (end + 0.5 * core > 0.5 * kPi) end = 0.5 * kPi;  // no sliver at the horizon
    const Ring ring = integrate_ring(begin, end, alpha);
    append_cells(ring, index, texel, samples);
    sum += 2.0 * kPi * ring.integral;
    begin = end;
    end = begin + std::max(core, grid.growth * begin);
  }
  for (auto& sample : samples) sample.weight *= static_cast<float>(2.0 * kPi / sum);
  return samples;
}

}  // namespace velarium::bake
