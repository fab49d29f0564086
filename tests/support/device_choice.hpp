#pragma once

#include <cstdlib>
#include <string>

namespace velarium::test {

// VELARIUM_TEST_DEVICE chooses the device as EngineOptions::device does; unset: the best usable one.
[[nodiscard]] inline std::string device_choice() {
  const char* choice = std::getenv("VELARIUM_TEST_DEVICE");
  return choice != nullptr ? choice : "";
}

}  // namespace velarium::test
