#pragma once

// Pearson's chi-squared test of samplers against the densities that they claim.

#include "unit/shading/support.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace velarium::statistical {

using glm::vec2;
using glm::vec3;
using shading::Random;

// A statistic this large or larger has this probability where only chance is at work.
[[nodiscard]] double chi_squared_p_value(double statistic, int degrees_of_freedom);

struct Verdict {
  double statistic = 0.0;
  int degrees_of_freedom = 0;
  double p_value = 1.0;
  std::size_t worst_bin = 0;  // which of the bins was furthest off, and what it held
  double worst_observed = 0.0, worst_expected = 0.0;
};

// Counts against expected counts of the same total. Bins that expect less than 5 are pooled, since the distribution of
// the statistic holds for well-filled bins only; where nothing at all may fall, nothing may have fallen.
[[nodiscard]] Verdict compare_counts(std::span<const double> observed, std::span<const double> expected);

// Counts of pairs against independence: the expected table is the product of the margins, as observed.
[[nodiscard]] Verdict test_independence(std::span<const double> table, std::size_t columns);

// Whether a family of `tests` verdicts, each of which passes on its own, lets chance alone through 99 times of 100
// [Sidak 1967].
[[nodiscard]] testing::AssertionResult agrees(const Verdict& verdict, int tests);

struct Experiment {
  std::uint32_t samples = 200000;
  std::uint32_t seed = 1;
  std::uint32_t columns = 32, rows = 16;  // bins
  std::uint32_t fineness = 12;            // places a side of each bin that the density is read at
};

// On the unit square. A sample of nothing counts as outside, where 1 minus the integral of the density is expected.
[[nodiscard]] Verdict test_on_square(const std::function<std::optional<vec2>(Random&)>& sampler,
                                     const std::function<double(const vec2&)>& density, const Experiment& experiment);

// Part of the sphere as a square: columns are azimuths about the axis, rows run from the axis to where 1 - cos of the
// angle to it is `height`: 2 is all of the sphere, 1 a hemisphere. With focus 1 all bins have the same solid angle; a
// larger one makes them smaller near the axis, for narrow lobes.
struct SphereBins {
  vec3 axis{0.0f, 0.0f, 1.0f};
  int focus = 1;
  float height = 2.0f;
};

// On the sphere; pdf_sr is per steradian. A direction beyond the bins counts as outside.
[[nodiscard]] Verdict test_on_sphere(const std::function<std::optional<vec3>(Random&)>& sampler,
                                     const std::function<double(const vec3&)>& pdf_sr, const SphereBins& bins,
                                     const Experiment& experiment);

}  // namespace velarium::statistical
