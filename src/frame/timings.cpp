#include "frame/timings.hpp"

#include <velarium/median.hpp>

#include <span>
#include <string>
#include <utility>

namespace velarium::frame {
namespace {

std::vector<double> times_of(const std::string& name, std::span<const std::vector<graph::PassTiming>> frames) {
  std::vector<double> times;
  for (const auto& frame : frames)
    for (const auto& pass : frame)
      if (pass.name == name) times.push_back(pass.ms);
  return times;
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
  for (const auto& pass : frames_.front()) {
    std::vector<double> times = times_of(pass.name, std::span(frames_).subspan(first));
    // Maps that all frames share are drawn in the first alone.
    if (times.empty()) times.push_back(pass.ms);
    const double middle = median(times);
    report.passes.push_back({pass.name, middle, std::move(times)});
  }
}

}  // namespace velarium::frame
