#include "compare_report.hpp"

#include <velarium/error.hpp>
#include <velarium/options.hpp>
#include <velarium/version.hpp>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace velarium::app {
namespace {

std::string number_text(double value, std::string_view unit) {
  return fmt::format("{:.5g}{}{}", value, unit.empty() ? "" : " ", unit);
}

}  // namespace

const MetricInfo& info_of(Metric metric) {
  return metric_table()[static_cast<std::size_t>(metric)];
}

Metric parse_metric(const std::string& name) {
  std::vector<std::string> names;
  for (const MetricInfo& info : metric_table()) {
    if (info.name == name) return info.metric;
    names.emplace_back(info.name);
  }
  const std::string near = nearest_name(name, names);
  throw Error(ErrorCode::usage, fmt::format("'{}' is not one of {}{}", name, fmt::join(names, ", "),
                                            near.empty() ? "" : fmt::format("; did you mean {}?", near)));
}

std::string text_of(const Comparison& comparison, const CompareOptions& options, const Decision& decision) {
  std::string text = fmt::format("{} against {}\n", options.name, options.reference_name);
  text += fmt::format("  {} x {} pixels, {} compared, {}\n", comparison.width, comparison.height, comparison.pixels,
                      comparison.linear ? "linear light" : "display values");
  for (const MetricInfo& info : metric_table()) {
    text += fmt::format("{} {:<13} {:>13}   {}\n", info.metric == decision.metric ? ">" : " ", info.title,
                        number_text(comparison.value(info.metric), info.unit), info.help);
  }
  text += fmt::format("  {:<13} {:>13}   of a channel, at pixel ({}, {})\n", "largest",
                      number_text(comparison.largest, ""), comparison.largest_x, comparison.largest_y);
  return text;
}

std::string verdict_of(const Comparison& comparison, const Decision& decision) {
  const MetricInfo& info = info_of(decision.metric);
  return fmt::format("{} {} is {} the threshold of {}", info.title,
                     number_text(comparison.value(decision.metric), info.unit),
                     comparison.within(decision.metric, decision.threshold) ? "within" : "beyond",
                     number_text(decision.threshold, info.unit));
}

nlohmann::ordered_json json_of(const Comparison& comparison, const CompareOptions& options, const Decision& decision) {
  nlohmann::ordered_json metrics;
  for (const MetricInfo& info : metric_table()) metrics[info.name] = comparison.value(info.metric);
  nlohmann::ordered_json json{
      {"velarium", kVersion},
      {"picture", options.name},
      {"reference", options.reference_name},
      {"width", comparison.width},
      {"height", comparison.height},
      {"pixels", comparison.pixels},
      {"values", comparison.linear ? "linear" : "display"},
      {"metrics", std::move(metrics)},
      {"largest", {{"difference", comparison.largest}, {"x", comparison.largest_x}, {"y", comparison.largest_y}}},
      {"pixels_per_degree", options.pixels_per_degree},
      {"tolerance", options.tolerance}};
  if (comparison.linear) {
    json["exposures"] = {
        {"count", comparison.exposures}, {"first", comparison.first_exposure}, {"last", comparison.last_exposure}};
  }
  json["metric"] = info_of(decision.metric).name;
  json["threshold"] = decision.threshold;
  json["within"] = comparison.within(decision.metric, decision.threshold);
  json["notes"] = comparison.notes;
  return json;
}

}  // namespace velarium::app
