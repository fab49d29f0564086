#include "bench_statistics.hpp"

#include <velarium/median.hpp>

#include <algorithm>
#include <cmath>

namespace velarium::app {

double median_absolute_deviation(std::vector<double> values) {
  const double center = median(values);
  for (double& value : values) value = std::abs(value - center);
  return median(std::move(values));
}

std::optional<PowerFit> fit_power(std::span<const double> x, std::span<const double> y) {
  const auto count = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > 0.0 && y[i] > 0.0)) return std::nullopt;
    mean_x += std::log(x[i]) / count;
    mean_y += std::log(y[i]) / count;
  }
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = std::log(x[i]) - mean_x, dy = std::log(y[i]) - mean_y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  if (!(xx > 0.0)) return std::nullopt;
  PowerFit fit{.exponent = xy / xx, .standard_error = std::nullopt};
  // Rounding may leave a perfect fit slightly below nothing.
  if (x.size() >= 3) fit.standard_error = std::sqrt(std::max(yy - xy * xy / xx, 0.0) / (count - 2.0) / xx);
  return fit;
}

}  // namespace velarium::app
