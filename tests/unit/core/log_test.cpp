#include "core/assert.hpp"
#include "core/log.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace velarium {
namespace {

TEST(Log, GoesToTheSinkOrNowhere) {
  std::vector<std::string> lines;
  set_log_sink([&](LogLevel level, std::string_view text) {
    lines.push_back((level == LogLevel::warning ? "warning " : "other ") + std::string(text));
  });
  log_warning("{} of {}", 1, 2);
  log_debug("plain");
  set_log_sink({});
  log_warning("dropped");
  EXPECT_EQ(lines, (std::vector<std::string>{"warning 1 of 2", "other plain"}));
}

TEST(AssertDeathTest, SaysWhatWasBroken) {
  EXPECT_DEATH(VEL_ASSERT(1 + 1 == 3), "broken invariant: 1 \\+ 1 == 3");
  VEL_ASSERT(1 + 1 == 2);
}

}  // namespace
}  // namespace velarium
