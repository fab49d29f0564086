#include "bench_sweep.hpp"

#include "bench_statistics.hpp"
#include "parse.hpp"

#include <velarium/error.hpp>
#include <velarium/options.hpp>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>

namespace velarium::app {
namespace {

// From what a game has to what nobody asks for, in steps of which the fit weighs each alike.
const std::array<SweepKind, 4> kSweeps{{
    {"resolution", SweepKind::Subject::resolution, "", {180, 360, 720, 1440}},
    {"lights", SweepKind::Subject::scene, "builtin:atrium?sun=off&lights=", {16, 64, 256, 1024}},
    {"triangles", SweepKind::Subject::scene, "builtin:terrain?triangles=", {10'000, 100'000, 1'000'000, 10'000'000}},
    {"instances", SweepKind::Subject::scene, "builtin:knots?instances=", {1, 8, 64, 512, 4096}},
}};

bool is_option(std::string_view key) {
  const auto all = option_table();
  return std::any_of(all.begin(), all.end(), [&](const OptionInfo& option) { return option.key == key; });
}

std::string optional_text(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f}", *value) : "";
}

nlohmann::ordered_json optional_json(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace

SweepKind find_sweep(std::string_view name) {
  if (is_option(name)) return {std::string(name), SweepKind::Subject::option, std::string(name), {}};
  std::vector<std::string_view> names;
  for (const SweepKind& kind : kSweeps) {
    if (kind.name == name) return kind;
    names.emplace_back(kind.name);
  }
  throw Error(ErrorCode::usage, fmt::format("'{}' is not one of {}, nor an option", name, fmt::join(names, ", ")));
}

std::vector<std::uint32_t> parse_sweep_points(std::string_view text) {
  std::vector<std::uint32_t> points;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    points.push_back(parse_count(rest.substr(0, comma), 1, std::numeric_limits<std::uint32_t>::max()));
    if (points.size() > 1 && points.back() <= points[points.size() - 2])
      throw Error(ErrorCode::usage, fmt::format("'{}' does not rise from number to number", text));
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (points.size() < 2) throw Error(ErrorCode::usage, fmt::format("'{}' is one point; a sweep needs two", text));
  return points;
}

std::vector<SweepPoint> points_of(const SweepKind& kind, const std::vector<std::uint32_t>& values,
                                  const std::string& scene, std::uint32_t width, std::uint32_t height) {
  std::vector<SweepPoint> points;
  for (const std::uint32_t value : values) {
    if (kind.subject == SweepKind::Subject::scene) {
      points.push_back({kind.takes_value + std::to_string(value), width, height, static_cast<double>(value), ""});
      continue;
    }
    if (kind.subject == SweepKind::Subject::option) {
      points.push_back({scene, width, height, static_cast<double>(value), kind.takes_value});
      continue;
    }
    const auto scaled = static_cast<std::uint32_t>((std::uint64_t{value} * width + height / 2) / height);
    const std::uint32_t across = std::max(scaled, 1u);
    points.push_back({scene, across, value, static_cast<double>(across) * value, ""});
  }
  return points;
}

std::vector<Growth> growth_of(const std::vector<SweepPoint>& points, const std::vector<Figures>& figures) {
  std::vector<double> x;
  for (const SweepPoint& point : points) x.push_back(point.x);
  std::vector<Growth> result;
  for (const Interval& first : figures.front().intervals) {
    Growth growth;
    growth.name = first.name;
    for (const Figures& at : figures) {
      for (const Interval& interval : at.intervals) {
        if (interval.name == first.name) growth.ms.push_back(interval.ms);
      }
    }
    const bool idle = std::all_of(growth.ms.begin(), growth.ms.end(), [](double ms) { return ms == 0.0; });
    if (growth.ms.size() != points.size() || idle) continue;
    if (growth.ms.front() > 0.0) growth.ratio = growth.ms.back() / growth.ms.front();
    if (const auto fit = fit_power(x, growth.ms)) {
      growth.exponent = fit->exponent;
      growth.standard_error = fit->standard_error;
    }
    result.push_back(std::move(growth));
  }
  return result;
}

std::string table_of(const SweepKind& kind, const std::vector<SweepPoint>& points, const std::vector<Growth>& growth) {
  const bool resolution = kind.subject == SweepKind::Subject::resolution;
  std::string text = fmt::format("\n{:<24}", resolution ? "ms by pixels" : fmt::format("ms by {}", kind.name));
  for (const SweepPoint& point : points) text += fmt::format("{:>11.0f}", point.x);
  text += fmt::format("{:>9}{:>18}\n", "growth", "exponent");
  for (const Growth& row : growth) {
    text += fmt::format("{:<24}", row.name);
    for (const double ms : row.ms) text += fmt::format("{:>11.3f}", ms);
    const std::string error = row.standard_error ? " +- " + optional_text(row.standard_error) : "";
    text += fmt::format("{:>9.2f}{:>18}\n", row.ratio, optional_text(row.exponent) + error);
  }
  return text;
}

nlohmann::ordered_json json_of(const SweepKind& kind, const std::vector<SweepPoint>& points,
                               const std::vector<Growth>& growth) {
  nlohmann::ordered_json x = nlohmann::ordered_json::array(), rows = nlohmann::ordered_json::array();
  for (const SweepPoint& point : points) x.push_back(point.x);
  for (const Growth& row : growth) {
    rows.push_back({{"name", row.name},
                    {"ms", row.ms},
                    {"growth", row.ratio},
                    {"exponent", optional_json(row.exponent)},
                    {"standard_error", optional_json(row.standard_error)}});
  }
  return {{"of", kind.name}, {"x", std::move(x)}, {"intervals", std::move(rows)}};
}

std::string csv_of(const std::vector<SweepPoint>& points, const std::vector<Growth>& growth) {
  std::string text = "name";
  for (const SweepPoint& point : points) text += fmt::format(",{:.0f}", point.x);
  text += ",growth,exponent,standard_error\n";
  for (const Growth& row : growth) {
    text += fmt::format("{},{:.4f},{:.4f},{},{}\n", row.name, fmt::join(row.ms, ","), row.ratio,
                        optional_text(row.exponent), optional_text(row.standard_error));
  }
  return text;
}

}  // namespace velarium::app
