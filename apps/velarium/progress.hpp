#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace velarium::app {

enum class ProgressStyle { none, bar, plain, json };

// "auto" is a bar on a terminal and plain lines elsewhere. Throws Error(usage) for an unknown name.
[[nodiscard]] ProgressStyle parse_progress(const std::string& name);

// Says on standard error how far a picture is, and how long the rest will take.
class Progress {
 public:
  explicit Progress(ProgressStyle style) : style_(style) {}
  // Takes the bar away, so that the next line starts clean.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Frames done.
  void update(std::uint32_t done, std::uint32_t of);
  // The share of the work that is done, 0..1.
  void update(double share);

 private:
  using Clock = std::chrono::steady_clock;

  void say(const std::string& what, const std::string& json, double share);
  [[nodiscard]] double seconds_left(double share) const;
  [[nodiscard]] bool due(bool last);

  ProgressStyle style_;
  Clock::time_point start_ = Clock::now(), last_line_{};
  bool bar_shown_ = false;
};

}  // namespace velarium::app
