#pragma once

#include "bench_figures.hpp"

#include <optional>
#include <string_view>

namespace velarium::app {

// One thing that a sweep changes: what it is called, and the points that are measured by default.
struct SweepKind {
  enum class Subject { scene, option, resolution };
  std::string name;
  Subject subject;
  std::string
      takes_value;  // the scene that ends in the value as its parameter, or the option; empty: the picture's height
  std::vector<std::uint32_t> points;  // none: they have to be given
};

struct SweepPoint {
  std::string scene;
  std::uint32_t width, height;
  double x;            // what times are fitted over: the value, or pixels
  std::string option;  // that is set to the value; empty: none
};

// By name, or the key of an option whose value is a whole number. Throws Error(usage) that lists the names.
[[nodiscard]] SweepKind find_sweep(std::string_view name);
// "16,64,256": rising whole numbers, at least two. Throws Error(usage).
[[nodiscard]] std::vector<std::uint32_t> parse_sweep_points(std::string_view text);
// `scene` and the size's shape are those of a sweep of resolution or of an option.
[[nodiscard]] std::vector<SweepPoint> points_of(const SweepKind& kind, const std::vector<std::uint32_t>& values,
                                                const std::string& scene, std::uint32_t width, std::uint32_t height);

// How one interval grows: its time at each point, over the first, and the power of x that fits best.
struct Growth {
  std::string name;
  std::vector<double> ms;
  double ratio = 0;  // last over first; 0 where the first took no time
  std::optional<double> exponent, standard_error;
};

// Intervals that every point has and that take time: some passes run in a picture's first or last frame alone.
[[nodiscard]] std::vector<Growth> growth_of(const std::vector<SweepPoint>& points, const std::vector<Figures>& figures);
[[nodiscard]] std::string table_of(const SweepKind& kind, const std::vector<SweepPoint>& points,
                                   const std::vector<Growth>& growth);
[[nodiscard]] nlohmann::ordered_json json_of(const SweepKind& kind, const std::vector<SweepPoint>& points,
                                             const std::vector<Growth>& growth);
// A line an interval: name, a time for each point, growth, exponent, standard error.
[[nodiscard]] std::string csv_of(const std::vector<SweepPoint>& points, const std::vector<Growth>& growth);

}  // namespace velarium::app
