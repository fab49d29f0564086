#pragma once

#include "bench_figures.hpp"

#include <span>

namespace velarium::app {

struct Change {
  std::string scene;  // label_of()
  Interval before, after;
  [[nodiscard]] double ratio() const { return after.ms / before.ms; }
  // Medians farther apart than two standard deviations of the difference of two single frames. Medians themselves are
  // surer than frames; the rest is left for machines that run faster at one time than at another.
  [[nodiscard]] bool beyond_noise() const;
};

// Intervals with a name that both have, of scenes and sizes that both have, in the order of `after`.
[[nodiscard]] std::vector<Change> changes(std::span<const Figures> before, std::span<const Figures> after);
[[nodiscard]] std::string table_of(std::span<const Change> changes);

// Throws Error(comparison_differs) where an interval is beyond the noise and takes more than `ratio` times what it
// took.
void check_changes(std::span<const Change> changes, double ratio);

}  // namespace velarium::app
