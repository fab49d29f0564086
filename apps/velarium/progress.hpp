#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace velarium::app {

enum class ProgressStyle { none, bar, plain, json };

// "auto" is a bar on a terminal and plain lines elsewhere. Throws Error(usage) for an unknown name.
[[nodiscard]] ProgressStyle parse_progress(const std::string& name);

// Says on standard error how far a render is: frames done, and how long the others will take.
class Progress {
 public:
  explicit Progress(ProgressStyle style) : style_(style) {}
  // Takes the bar away, so that the next line starts clean.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::uint32_t done, std::uint32_t of);

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] double seconds_left(std::uint32_t done, std::uint32_t of) const;
  [[nodiscard]] bool due(bool last);

  ProgressStyle style_;
  Clock::time_point start_ = Clock::now(), last_line_{};
  bool bar_shown_ = false;
};

}  // namespace velarium::app
