#pragma once

#include <functional>
#include <string_view>

namespace velarium {

enum class LogLevel { debug, info, warning };

// Where the library's remarks go. It prints nothing by itself: without a sink they are dropped.
// Called from any thread, one call at a time.
using LogSink = std::function<void(LogLevel, std::string_view)>;
void set_log_sink(LogSink sink);

}  // namespace velarium
