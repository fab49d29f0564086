#include "statistical/chi_squared.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace velarium::statistical {
namespace {

constexpr double kLeastExpected = 5.0;  // Cochran 1952
constexpr double kSignificance = 0.01;  // of a whole family of tests
constexpr double kRounding = 1e-5;      // by which a direction in fp32 may be beyond the last row

// P(a, x) by its power series, for x < a + 1.
double lower_gamma_share(double a, double x) {
  double term = 1.0 / a, sum = term;
  for (double n = a + 1.0; term > sum * 1e-15; n += 1.0) {
    term *= x / n;
    sum += term;
  }
  return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

// Q(a, x) by its continued fraction, for x >= a + 1 [modified Lentz; Press et al. 1992].
double upper_gamma_share(double a, double x) {
  constexpr double kTiny = 1e-300;
  double b = x + 1.0 - a, c = 1.0 / kTiny, d = 1.0 / b, product = d;
  for (int i = 1; i < 100000; ++i) {
    const double numerator = -i * (i - a);
    b += 2.0;
    d = numerator * d + b;
    c = b + numerator / c;
    if (std::abs(d) < kTiny) d = kTiny;
    if (std::abs(c) < kTiny) c = kTiny;
    d = 1.0 / d;
    product *= d * c;
    if (std::abs(d * c - 1.0) < 1e-14) break;
  }
  return product * std::exp(a * std::log(x) - x - std::lgamma(a));
}

void add_bin(Verdict& verdict, std::size_t bin, double observed, double expected) {
  const double off = (observed - expected) * (observed - expected) / expected;
  const double worst = verdict.worst_observed - verdict.worst_expected;
  if (verdict.worst_expected == 0.0 || off > worst * worst / verdict.worst_expected) {
    verdict.worst_bin = bin;
    verdict.worst_observed = observed;
    verdict.worst_expected = expected;
  }
  verdict.statistic += off;
  ++verdict.degrees_of_freedom;
}

// Two axes that complete a frame; any will do, and the shaders' own is under test.
void complete_frame(const vec3& axis, vec3& x, vec3& y) {
  const vec3 helper = std::abs(axis.x) < 0.5f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
  x = glm::normalize(glm::cross(helper, axis));
  y = glm::cross(axis, x);
}

// 1 - cos of the angle to the axis is height v^focus.
class SphereMap {
 public:
  explicit SphereMap(const SphereBins& bins) : bins_(bins) { complete_frame(bins.axis, x_, y_); }

  [[nodiscard]] std::optional<vec2> square_from(const vec3& d) const {
    const vec3 off = d - bins_.axis;  // its length keeps the digits that the cosine loses
    const double v = std::pow(0.5 * glm::dot(off, off) / bins_.height, 1.0 / bins_.focus);
    if (v > 1.0 + kRounding) return std::nullopt;
    const double azimuth = std::atan2(glm::dot(d, y_), glm::dot(d, x_));
    return vec2(0.5 + azimuth / (2.0 * shading::kPiExact), std::min(v, 1.0));
  }

  [[nodiscard]] vec3 direction_from(const vec2& p) const {
    const double below = bins_.height * std::pow(static_cast<double>(p.y), bins_.focus);
    const double sine = std::sqrt(below * (2.0 - below)), azimuth = (p.x - 0.5) * 2.0 * shading::kPiExact;
    return glm::normalize(static_cast<float>(sine * std::cos(azimuth)) * x_ +
                          static_cast<float>(sine * std::sin(azimuth)) * y_ +
                          static_cast<float>(1.0 - below) * bins_.axis);
  }

  // Steradians per unit of the square.
  [[nodiscard]] double jacobian(const vec2& p) const {
    return 2.0 * shading::kPiExact * bins_.height * bins_.focus * std::pow(static_cast<double>(p.y), bins_.focus - 1);
  }

 private:
  SphereBins bins_;
  vec3 x_, y_;
};

std::vector<double> expected_counts(const std::function<double(const vec2&)>& density, const Experiment& e) {
  std::vector<double> counts;
  for (std::uint32_t row = 0; row < e.rows; ++row) {
    for (std::uint32_t column = 0; column < e.columns; ++column) {
      double sum = 0.0;
      for (std::uint32_t i = 0; i < e.fineness * e.fineness; ++i) {
        const vec2 offset =
            (vec2(i % e.fineness, i / e.fineness) + 0.5f) / static_cast<float>(e.fineness);  // in the bin
        sum += density((vec2(column, row) + offset) / vec2(e.columns, e.rows));
      }
      counts.push_back(sum * e.samples / (1.0 * e.fineness * e.fineness * e.columns * e.rows));
    }
  }
  return counts;
}

std::size_t bin_of(const vec2& p, const Experiment& e) {
  const auto column = std::min(static_cast<std::uint32_t>(p.x * static_cast<float>(e.columns)), e.columns - 1);
  const auto row = std::min(static_cast<std::uint32_t>(p.y * static_cast<float>(e.rows)), e.rows - 1);
  return std::size_t{row} * e.columns + column;
}

}  // namespace

double chi_squared_p_value(double statistic, int degrees_of_freedom) {
  const double a = 0.5 * degrees_of_freedom, x = 0.5 * statistic;
  if (x <= 0.0) return 1.0;
  return x < a + 1.0 ? 1.0 - lower_gamma_share(a, x) : upper_gamma_share(a, x);
}

Verdict compare_counts(std::span<const double> observed, std::span<const double> expected) {
  Verdict verdict;
  double pooled_observed = 0.0, pooled_expected = 0.0;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (expected[i] >= kLeastExpected) {
      add_bin(verdict, i, observed[i], expected[i]);
    } else {
      pooled_observed += observed[i];
      pooled_expected += expected[i];
    }
  }
  // A pool that is itself too small still stands: what fell where nothing may fall must not be overlooked.
  if (pooled_observed > 0.0 || pooled_expected >= kLeastExpected)
    add_bin(verdict, observed.size(), pooled_observed, std::max(pooled_expected, 1e-3));
  --verdict.degrees_of_freedom;  // the totals agree
  verdict.p_value = chi_squared_p_value(verdict.statistic, std::max(verdict.degrees_of_freedom, 1));
  return verdict;
}

Verdict test_independence(std::span<const double> table, std::size_t columns) {
  const std::size_t rows = table.size() / columns;
  std::vector<double> column_sums(columns), row_sums(rows);
  for (std::size_t i = 0; i < table.size(); ++i) {
    column_sums[i % columns] += table[i];
    row_sums[i / columns] += table[i];
  }
  const double total = std::accumulate(row_sums.begin(), row_sums.end(), 0.0);
  Verdict verdict;
  for (std::size_t i = 0; i < table.size(); ++i)
    add_bin(verdict, i, table[i], column_sums[i % columns] * row_sums[i / columns] / total);
  verdict.degrees_of_freedom = static_cast<int>((columns - 1) * (rows - 1));
  verdict.p_value = chi_squared_p_value(verdict.statistic, verdict.degrees_of_freedom);
  return verdict;
}

testing::AssertionResult agrees(const Verdict& verdict, int tests) {
  const double threshold = 1.0 - std::pow(1.0 - kSignificance, 1.0 / tests);
  auto result = verdict.p_value >= threshold ? testing::AssertionSuccess() : testing::AssertionFailure();
  return result << "p = " << verdict.p_value << ", at least " << threshold << " passes; chi squared "
                << verdict.statistic << " with " << verdict.degrees_of_freedom << " degrees of freedom; bin "
                << verdict.worst_bin << " holds " << verdict.worst_observed << " where " << verdict.worst_expected
                << " are expected";
}

Verdict test_on_square(const std::function<std::optional<vec2>(Random&)>& sampler,
                       const std::function<double(const vec2&)>& density, const Experiment& e) {
  std::vector<double> expected = expected_counts(density, e), observed(expected.size() + 1);
  expected.push_back(std::max(e.samples - std::accumulate(expected.begin(), expected.end(), 0.0), 0.0));
  Random random(e.seed);
  for (std::uint32_t i = 0; i < e.samples; ++i) {
    const std::optional<vec2> p = sampler(random);
    ++observed[p ? bin_of(*p, e) : observed.size() - 1];
  }
  return compare_counts(observed, expected);
}

Verdict test_on_sphere(const std::function<std::optional<vec3>(Random&)>& sampler,
                       const std::function<double(const vec3&)>& pdf_sr, const SphereBins& bins, const Experiment& e) {
  const SphereMap map(bins);
  return test_on_square(
      [&](Random& random) {
        const std::optional<vec3> d = sampler(random);
        return d ? map.square_from(*d) : std::nullopt;
      },
      [&](const vec2& p) { return pdf_sr(map.direction_from(p)) * map.jacobian(p); }, e);
}

}  // namespace velarium::statistical
