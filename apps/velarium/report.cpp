#include "report.hpp"

#include "console.hpp"

#include <velarium/files.hpp>

#include <fmt/core.h>

#include <sys/resource.h>

#include <array>

namespace velarium::app {

double Stopwatch::lap_ms() {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double, std::milli> passed = now - last_;
  last_ = now;
  return passed.count();
}

nlohmann::ordered_json json_of(const RenderReport& report) {
  nlohmann::ordered_json passes = nlohmann::ordered_json::array();
  for (const PassTime& pass : report.passes) passes.push_back({{"name", pass.name}, {"ms", pass.ms}});
  return {{"frame_ms", report.frame_ms},
          {"passes", std::move(passes)},
          {"frames", report.frames},
          {"device", report.device},
          {"device_bytes", report.device_bytes},
          {"shadow_maps", json_of(report.shadow_maps)}};
}

nlohmann::ordered_json json_of(const std::vector<MapMemory>& maps) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const MapMemory& map : maps) json.push_back({{"name", map.name}, {"bytes", map.bytes}});
  return json;
}

nlohmann::ordered_json json_of(const Phases& phases) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, ms] : phases) json[name + "_ms"] = ms;
  return json;
}

void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json) {
  // Names come from files, whose bytes need not be UTF-8.
  const std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  file == "-" ? print(text) : write_text(file, text);
}

std::uint64_t peak_process_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

std::string time_text(double ms) {
  return ms < 1000.0 ? fmt::format("{:.1f} ms", ms) : fmt::format("{:.2f} s", ms / 1000.0);
}

std::string size_text(std::uint64_t bytes) {
  constexpr std::array kUnits{"kB", "MB", "GB", "TB"};
  if (bytes < 1000) return fmt::format("{} B", bytes);
  double value = static_cast<double>(bytes) / 1000.0;
  std::size_t unit = 0;
  for (; value >= 999.95 && unit + 1 < kUnits.size(); ++unit) value /= 1000.0;
  return fmt::format("{:.1f} {}", value, kUnits[unit]);
}

}  // namespace velarium::app
