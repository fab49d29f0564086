#include "progress.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace velarium::app {
namespace {

// "42 s", "3 min 20 s", "2 h 5 min"
std::string duration_text(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

ProgressStyle parse_progress(const std::string& name) {
  if (name == "auto") return ::isatty(STDERR_FILENO) != 0 ? ProgressStyle::bar : ProgressStyle::plain;
  constexpr std::array<std::pair<const char*, ProgressStyle>, 4> kStyles{{{"bar", ProgressStyle::bar},
                                                                          {"plain", ProgressStyle::plain},
                                                                          {"json", ProgressStyle::json},
                                                                          {"none", ProgressStyle::none}}};
  for (const auto& [known, style] : kStyles) {
    if (name == known) return style;
  }
  throw Error(ErrorCode::usage, fmt::format("'{}' is not one of auto, bar, plain, json, none", name));
}

Progress::~Progress() {
  if (bar_shown_) std::fputs("\r\033[K", stderr);
}

void Progress::update(std::uint32_t done, std::uint32_t of) {
  say(fmt::format("frame {} of {}", done, of), fmt::format("\"frame\":{},\"of\":{}", done, of),
      static_cast<double>(done) / of);
}

void Progress::update(double share) {
  say(fmt::format("{:.0f} %", 100.0 * share), fmt::format("\"share\":{:.4f}", share), share);
}

void Progress::say(const std::string& what, const std::string& json, double share) {
  // Before anything is done nobody knows how long the rest takes.
  if (style_ == ProgressStyle::none || !(share > 0.0) || !due(share >= 1.0)) return;
  const double left = seconds_left(share);
  if (style_ == ProgressStyle::json) {
    fmt::print(stderr, "{{{},\"seconds_left\":{:.1f}}}\n", json, left);
  } else if (style_ == ProgressStyle::plain) {
    fmt::print(stderr, "{}, {} left\n", what, duration_text(left));
  } else {
    constexpr double kBarWidth = 30;
    const auto filled = static_cast<std::size_t>(kBarWidth * share);
    const std::string bar = std::string(filled, '#') + std::string(static_cast<std::size_t>(kBarWidth) - filled, '.');
    fmt::print(stderr, "\r\033[K[{}] {}, {} left", bar, what, duration_text(left));
    bar_shown_ = true;
  }
  std::fflush(stderr);
}

double Progress::seconds_left(double share) const {
  const std::chrono::duration<double> passed = Clock::now() - start_;
  return passed.count() / share * (1.0 - share);
}

// Every frame where a program or a terminal reads; in a log, one line in two seconds and the last one.
bool Progress::due(bool last) {
  if (style_ != ProgressStyle::plain) return true;
  const auto now = Clock::now();
  if (!last && now - last_line_ < std::chrono::seconds(2)) return false;
  last_line_ = now;
  return true;
}

}  // namespace velarium::app
