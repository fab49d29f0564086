#pragma once

// What `velarium compare` says.

#include <velarium/compare.hpp>

#include <nlohmann/json.hpp>

#include <string>

namespace velarium::app {

// What decides whether pictures are alike.
struct Decision {
  Metric metric = Metric::flip;
  double threshold = 0.0;
};

[[nodiscard]] const MetricInfo& info_of(Metric metric);

// Throws Error(usage) that lists the names, and says which is near.
[[nodiscard]] Metric parse_metric(const std::string& name);

// The numbers as a table for people.
[[nodiscard]] std::string text_of(const Comparison& comparison, const CompareOptions& options,
                                  const Decision& decision);

// "FLIP 0.12 is beyond the threshold of 0.05"
[[nodiscard]] std::string verdict_of(const Comparison& comparison, const Decision& decision);

// Infinite numbers become null.
[[nodiscard]] nlohmann::ordered_json json_of(const Comparison& comparison, const CompareOptions& options,
                                             const Decision& decision);

}  // namespace velarium::app
