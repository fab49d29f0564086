#include "support/device.hpp"

#include <cstdlib>

namespace velarium::test {

std::string device_choice() {
  const char* choice = std::getenv("VELARIUM_TEST_DEVICE");
  return choice != nullptr ? choice : "";
}

EngineOptions validated() {
  return {.device = device_choice(), .validation = true};
}

Engine& engine() {
  static Engine shared(validated());
  return shared;
}

}  // namespace velarium::test
