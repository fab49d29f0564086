#pragma once

// The arithmetic of measuring, on plain numbers.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace velarium::app {

// Median of the distances from the median: what half of the values stay within, whatever the others do.
[[nodiscard]] double median_absolute_deviation(std::vector<double> values);

// y = c x^exponent
struct PowerFit {
  double exponent = 0;
  std::optional<double> standard_error;  // of the exponent; needs three points
};

// The straight line through (log x, log y) by least squares. Nothing where fewer than two x differ, or where an x or y
// is not positive. As many x as y.
[[nodiscard]] std::optional<PowerFit> fit_power(std::span<const double> x, std::span<const double> y);

}  // namespace velarium::app
