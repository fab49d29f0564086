#pragma once

// The device that GPU tests run on, as an engine.

#include "support/device_choice.hpp"

#include <velarium/engine.hpp>

namespace velarium::test {

[[nodiscard]] EngineOptions validated();

// The one engine of a test program. It validates: a message of the layers is an Error(internal), which fails the test.
[[nodiscard]] Engine& engine();

}  // namespace velarium::test
