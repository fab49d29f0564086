#include "console.hpp"

#include <velarium/error.hpp>
#include <velarium/log.hpp>

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace velarium::app {
namespace {

Verbosity current = Verbosity::normal;

void say(std::string_view kind, std::string_view text) {
  fmt::print(stderr, "velarium: {}{}\n", kind, text);
}

void on_log(LogLevel level, std::string_view text) {
  if (level == LogLevel::warning) return say_warning(text);
  if (current == Verbosity::verbose) say("", text);
}

}  // namespace

void set_verbosity(Verbosity wanted) {
  current = wanted;
  set_log_sink(on_log);
}

Verbosity verbosity() {
  return current;
}

void say_error(std::string_view text) {
  say("error: ", text);
}
void say_warning(std::string_view text) {
  if (current != Verbosity::quiet) say("warning: ", text);
}
void say_note(std::string_view text) {
  if (current != Verbosity::quiet) say("note: ", text);
}

void print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) {
    throw Error(ErrorCode::output_not_written, fmt::format("standard output: {}", std::strerror(errno)));
  }
}

}  // namespace velarium::app
