#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace velarium {

// The value in the middle, as reports state times; of an even number of values the mean of the two there; of none 0.
template <class Number>
[[nodiscard]] double median(std::vector<Number> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return static_cast<double>(*middle);
  return 0.5 * (static_cast<double>(*middle) + static_cast<double>(*std::max_element(values.begin(), middle)));
}

}  // namespace velarium
