#pragma once

#include "report.hpp"

#include <string>
#include <vector>

namespace velarium::app {

// What one interval took: median and median absolute deviation over the frames, milliseconds.
struct Interval {
  std::string name;
  double ms = 0, mad_ms = 0;
};

// What one scene took at one size. Two intervals more than passes: kFrame and kClock.
struct Figures {
  std::string scene;
  std::uint32_t width = 0, height = 0, frames = 0;
  std::vector<Interval> intervals;
  std::string device;
  std::uint64_t device_bytes = 0;
  std::vector<MapMemory> shadow_maps;
  Phases phases;
};

inline constexpr const char* kFrame = "frame on the device";
inline constexpr const char* kClock = "frame by the clock";

// The frames of one scene, gathered over several renders.
class Samples {
 public:
  // `clock_ms`: each of the report's frames.
  void add(const RenderReport& report, const std::vector<double>& clock_ms);
  // All but `scene`, the size and the phases.
  [[nodiscard]] Figures figures() const;

 private:
  std::vector<double>& series(const std::string& name);

  std::vector<std::pair<std::string, std::vector<double>>> series_;
  std::string device_;
  std::uint64_t device_bytes_ = 0;
  std::vector<MapMemory> shadow_maps_;
};

// "builtin:atrium, 640 x 360"
[[nodiscard]] std::string label_of(const Figures& figures);
[[nodiscard]] std::string table_of(const Figures& figures);

[[nodiscard]] nlohmann::ordered_json json_of(const Figures& figures);
// The scenes of a file that bench wrote with --json. Throws Error(input_missing, input_invalid).
[[nodiscard]] std::vector<Figures> read_figures(const std::filesystem::path& file);

}  // namespace velarium::app
