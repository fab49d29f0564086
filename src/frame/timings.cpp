#include "frame/timings.hpp"

#include <algorithm>
#include <utility>

namespace velarium::frame {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace

void Timings::add_frame(const std::vector<graph::PassTiming>& passes) {
  frames_.push_back(passes);
}

void Timings::write(RenderReport& report) const {
  report.frames = static_cast<std::uint32_t>(frames_.size());
  if (frames_.empty()) return;
  const std::size_t first = frames_.size() > 1 ? 1 : 0;
  std::vector<double> totals;
  for (std::size_t f = first; f < frames_.size(); ++f) {
    double total = 0;
    for (const auto& pass : frames_[f]) total += pass.ms;
    totals.push_back(total);
  }
  report.frame_ms = median(totals);
  report.frames_ms = std::move(totals);
  for (std::size_t p = 0; p < frames_.front().size(); ++p) {
    std::vector<double> times;
    for (std::size_t f = first; f < frames_.size(); ++f) times.push_back(frames_[f][p].ms);
    const double middle = median(times);
    report.passes.push_back({frames_.front()[p].name, middle, std::move(times)});
  }
}

}  // namespace velarium::frame
