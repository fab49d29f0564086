#include "core/log.hpp"

#include <mutex>
#include <utility>

namespace velarium {
namespace {

struct Sink {
  std::mutex mutex;
  LogSink sink;
};

Sink& sink() {
  static Sink instance;
  return instance;
}

}  // namespace

void set_log_sink(LogSink new_sink) {
  const std::lock_guard lock(sink().mutex);
  sink().sink = std::move(new_sink);
}

void log_message(LogLevel level, std::string_view text) {
  const std::lock_guard lock(sink().mutex);
  if (sink().sink) sink().sink(level, text);
}

}  // namespace velarium
