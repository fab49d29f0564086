#include "bench_figures.hpp"

#include "bench_statistics.hpp"

#include <velarium/error.hpp>
#include <velarium/median.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <fstream>

namespace velarium::app {

std::vector<double>& Samples::series(const std::string& name) {
  const auto known = std::find_if(series_.begin(), series_.end(), [&](const auto& s) { return s.first == name; });
  if (known != series_.end()) return known->second;
  return series_.emplace_back(name, std::vector<double>{}).second;
}

void Samples::add(const RenderReport& report, const std::vector<double>& clock_ms) {
  const auto append = [this](const std::string& name, const std::vector<double>& values) {
    std::vector<double>& all = series(name);
    all.insert(all.end(), values.begin(), values.end());
  };
  for (const PassTime& pass : report.passes) append(pass.name, pass.frames_ms);
  append(kFrame, report.frames_ms);
  append(kClock, clock_ms);
  device_ = report.device;
  device_bytes_ = std::max(device_bytes_, report.device_bytes);
  shadow_maps_ = report.shadow_maps;
}

Figures Samples::figures() const {
  Figures figures;
  for (const auto& [name, values] : series_) {
    figures.intervals.push_back({name, median(values), median_absolute_deviation(values)});
    figures.frames = static_cast<std::uint32_t>(values.size());
  }
  figures.device = device_;
  figures.device_bytes = device_bytes_;
  figures.shadow_maps = shadow_maps_;
  return figures;
}

std::string label_of(const Figures& figures) {
  return fmt::format("{}, {} x {}", figures.scene, figures.width, figures.height);
}

std::string table_of(const Figures& figures) {
  std::string text = fmt::format("\n{}\n", label_of(figures));
  for (const Interval& i : figures.intervals)
    text += fmt::format("  {:<32} {:>12.3f} ms  +- {:.3f}\n", i.name, i.ms, i.mad_ms);
  const auto row = [&text](std::string_view name, const std::string& value) {
    text += fmt::format("  {:<32} {:>12}\n", name, value);
  };
  row("device memory, peak", size_text(figures.device_bytes));
  for (const MapMemory& map : figures.shadow_maps) row(map.name + ", memory", size_text(map.bytes));
  for (const auto& [phase, ms] : figures.phases) row(phase, time_text(ms));
  return text;
}

nlohmann::ordered_json json_of(const Figures& figures) {
  nlohmann::ordered_json intervals = nlohmann::ordered_json::array();
  for (const Interval& i : figures.intervals)
    intervals.push_back({{"name", i.name}, {"ms", i.ms}, {"mad_ms", i.mad_ms}});
  return {{"scene", figures.scene},
          {"width", figures.width},
          {"height", figures.height},
          {"frames", figures.frames},
          {"intervals", intervals},
          {"device", figures.device},
          {"device_bytes", figures.device_bytes},
          {"shadow_maps", json_of(figures.shadow_maps)},
          {"phases", json_of(figures.phases)}};
}

std::vector<Figures> read_figures(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw Error(ErrorCode::input_missing, file, "cannot be opened");
  std::vector<Figures> all;
  try {
    const auto json = nlohmann::ordered_json::parse(in);
    for (const auto& scene : json.at("scenes")) {
      Figures& figures = all.emplace_back();
      scene.at("scene").get_to(figures.scene);
      scene.at("width").get_to(figures.width);
      scene.at("height").get_to(figures.height);
      scene.at("device").get_to(figures.device);
      for (const auto& i : scene.at("intervals"))
        figures.intervals.push_back({i.at("name"), i.at("ms").get<double>(), i.at("mad_ms").get<double>()});
    }
  } catch (const nlohmann::json::exception& error) {
    throw Error(ErrorCode::input_invalid, file,
                fmt::format("is not what `bench --json` writes: {}; measure again", error.what()));
  }
  return all;
}

}  // namespace velarium::app
