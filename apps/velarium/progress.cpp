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
  if (style_ == ProgressStyle::none || !due(done == of)) return;
  const double left = seconds_left(done, of);
  if (style_ == ProgressStyle::json) {
    fmt::print(stderr, "{{\"frame\":{},\"of\":{},\"seconds_left\":{:.1f}}}\n", done, of, left);
  } else if (style_ == ProgressStyle::plain) {
    fmt::print(stderr, "frame {} of {}, {} left\n", done, of, duration_text(left));
  } else {
    constexpr std::uint32_t kBarWidth = 30;
    const auto filled = static_cast<std::size_t>(std::uint64_t{kBarWidth} * done / of);
    const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
    fmt::print(stderr, "\r\033[K[{}] frame {} of {}, {} left", bar, done, of, duration_text(left));
    bar_shown_ = true;
  }
  std::fflush(stderr);
}

double Progress::seconds_left(std::uint32_t done, std::uint32_t of) const {
  const std::chrono::duration<double> passed = Clock::now() - start_;
  return passed.count() / done * (of - done);
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
