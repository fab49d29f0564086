#include "reference/passes.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

namespace velarium::reference {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kTile = 16;  // pixels a side: what a tile meets of the scene still lies in the cache
// The first passes are short, so that time limits and estimates of noise have something to go by; later ones amortise
// what a tile costs.
constexpr std::uint32_t kLongestPass = 16;
constexpr std::chrono::milliseconds kProgressInterval{100};

// Runs `work` on so many threads, the calling one among them, which is number 0. The first exception is rethrown.
template <class Work>
void on_threads(std::uint32_t count, const Work& work) {
  std::exception_ptr error;
  std::mutex error_mutex;
  const auto guarded = [&](std::uint32_t number) {
    try {
      work(number);
    } catch (...) {
      const std::lock_guard lock(error_mutex);
      if (!error) error = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::uint32_t i = 1; i < count; ++i) others.emplace_back(guarded, i);
    guarded(0);
  }
  if (error) std::rethrow_exception(error);
}

class Passes {
 public:
  Passes(const PathTracer& tracer, const Settings::reference_settings& settings,
         const std::function<bool(const Progress&)>& on_progress, Result& result)
      : tracer_(tracer),
        settings_(settings),
        on_progress_(on_progress),
        result_(result),
        columns_((result.film.width() + kTile - 1) / kTile),
        tiles_(columns_ * ((result.film.height() + kTile - 1) / kTile)) {
    const std::uint32_t cores = std::max(1u, std::thread::hardware_concurrency());
    result.threads = settings.threads > 0 ? static_cast<std::uint32_t>(settings.threads) : cores;
  }

  void run() {
    const auto wanted = static_cast<std::uint32_t>(settings_.spp);
    std::uint32_t length = 1;
    report(0, length);  // even the smallest picture asks once
    while (done_ < wanted && !stop_) {
      const std::uint32_t end = std::min(done_ + length, wanted);
      next_tile_ = 0;
      on_threads(result_.threads, [&](std::uint32_t number) { work(number, end); });
      done_ = end;
      length = std::min(2 * length, kLongestPass);
      if (settings_.noise > 0.0f && result_.film.relative_error() < static_cast<double>(settings_.noise)) break;
    }
    result_.finished = !refused_;
    result_.seconds = elapsed();
    result_.paths = paths_;
  }

 private:
  void work(std::uint32_t number, std::uint32_t end) {
    for (std::uint32_t tile; !stop_ && (tile = next_tile_.fetch_add(1)) < tiles_;) {
      paths_ += trace_tile(tile, end);
      if (settings_.time_limit > 0.0f && elapsed() > static_cast<double>(settings_.time_limit)) stop_ = true;
      if (number == 0) report(tile, end);
    }
  }

  std::uint64_t trace_tile(std::uint32_t tile, std::uint32_t end) {
    Film& film = result_.film;
    const std::uint32_t left = tile % columns_ * kTile, top = tile / columns_ * kTile;
    const std::uint32_t right = std::min(left + kTile, film.width()), bottom = std::min(top + kTile, film.height());
    for (std::uint32_t y = top; y < bottom; ++y)
      for (std::uint32_t x = left; x < right; ++x)
        for (std::uint32_t sample = done_; sample < end; ++sample)
          film.add(std::size_t{y} * film.width() + x, tracer_.trace({x, y}, sample));
    return std::uint64_t{right - left} * (bottom - top) * (end - done_);
  }

  void report(std::uint32_t tile, std::uint32_t end) {
    const auto now = Clock::now();
    if (!on_progress_ || now - last_report_ < kProgressInterval) return;
    last_report_ = now;
    const double samples = done_ + static_cast<double>(end - done_) * tile / tiles_;
    double share = samples / settings_.spp;
    if (settings_.time_limit > 0.0f) share = std::max(share, elapsed() / static_cast<double>(settings_.time_limit));
    if (on_progress_({std::min(share, 1.0), elapsed()})) return;
    refused_ = stop_ = true;
  }

  [[nodiscard]] double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  const PathTracer& tracer_;
  const Settings::reference_settings& settings_;
  const std::function<bool(const Progress&)>& on_progress_;
  Result& result_;
  const std::uint32_t columns_, tiles_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point last_report_{};
  std::uint32_t done_ = 0;  // paths of every pixel
  std::atomic<std::uint32_t> next_tile_{0};
  std::atomic<std::uint64_t> paths_{0};
  std::atomic<bool> stop_{false};
  bool refused_ = false;
};

}  // namespace

void trace_passes(const PathTracer& tracer, const Settings::reference_settings& settings,
                  const std::function<bool(const Progress&)>& on_progress, Result& result) {
  Passes(tracer, settings, on_progress, result).run();
}

}  // namespace velarium::reference
