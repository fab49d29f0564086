#include "support/device.hpp"

namespace velarium::test {

EngineOptions validated() {
  return {.device = device_choice(), .validation = true};
}

Engine& engine() {
  static Engine shared(validated());
  return shared;
}

}  // namespace velarium::test
