#pragma once

#include <velarium/engine.hpp>

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace velarium::app {

// Wall-clock time between marks.
class Stopwatch {
 public:
  // Milliseconds since construction or the last lap.
  double lap_ms();

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// The program's own steps around the frames: name and wall-clock milliseconds.
using Phases = std::vector<std::pair<std::string, double>>;

// Device times and memory of a render: frame_ms, passes, frames, device, device_bytes, shadow_maps.
[[nodiscard]] nlohmann::ordered_json json_of(const RenderReport& report);
[[nodiscard]] nlohmann::ordered_json json_of(const std::vector<MapMemory>& maps);
[[nodiscard]] nlohmann::ordered_json json_of(const Phases& phases);

// "-" is standard output.
void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json);

// The most memory that this process has held, in bytes.
[[nodiscard]] std::uint64_t peak_process_bytes();

// "12.3 ms" below a second, "4.56 s" above
[[nodiscard]] std::string time_text(double ms);
// "3.4 MB", in powers of 1000
[[nodiscard]] std::string size_text(std::uint64_t bytes);

}  // namespace velarium::app
