#include "bench_compare.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace velarium::app {

bool Change::beyond_noise() const {
  // The standard deviation of normal noise is 1.4826 times its median absolute deviation.
  constexpr double kSigma = 1.4826, kSigmas = 2.0;
  return std::abs(after.ms - before.ms) > kSigmas * kSigma * std::hypot(before.mad_ms, after.mad_ms);
}

std::vector<Change> changes(std::span<const Figures> before, std::span<const Figures> after) {
  std::vector<Change> result;
  for (const Figures& now : after) {
    const auto then = std::find_if(before.begin(), before.end(),
                                   [&](const Figures& figures) { return label_of(figures) == label_of(now); });
    if (then == before.end()) continue;
    for (const Interval& interval : now.intervals) {
      const auto old = std::find_if(then->intervals.begin(), then->intervals.end(),
                                    [&](const Interval& i) { return i.name == interval.name; });
      if (old != then->intervals.end() && old->ms > 0.0) result.push_back({label_of(now), *old, interval});
    }
  }
  return result;
}

std::string table_of(std::span<const Change> changes) {
  std::string text;
  const std::string* scene = nullptr;
  for (const Change& change : changes) {
    if (scene == nullptr || *scene != change.scene) {
      text += fmt::format("\n{}\n  {:<32} {:>20} {:>20} {:>7}\n", change.scene, "", "before, ms", "now, ms", "ratio");
      scene = &change.scene;
    }
    const auto cell = [](const Interval& i) { return fmt::format("{:.3f} +- {:.3f}", i.ms, i.mad_ms); };
    text += fmt::format("  {:<32} {:>20} {:>20} {:>7.3f}{}\n", change.after.name, cell(change.before),
                        cell(change.after), change.ratio(), change.beyond_noise() ? " *" : "");
  }
  return text + "\n* beyond the noise\n";
}

void check_changes(std::span<const Change> changes, double ratio) {
  for (const Change& change : changes) {
    if (!change.beyond_noise() || change.ratio() <= ratio) continue;
    throw Error(ErrorCode::comparison_differs, fmt::format("{}: {} takes {:.3f} times what it took, more than {}",
                                                           change.scene, change.after.name, change.ratio(), ratio));
  }
}

}  // namespace velarium::app
