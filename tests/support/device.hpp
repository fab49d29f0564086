#pragma once

// The device that GPU tests run on.

#include <velarium/engine.hpp>

#include <string>

namespace velarium::test {

// VELARIUM_TEST_DEVICE chooses the device as EngineOptions::device does; unset: the best usable one.
[[nodiscard]] std::string device_choice();

[[nodiscard]] EngineOptions validated();

// The one engine of a test program. It validates: a message of the layers is an Error(internal), which fails the test.
[[nodiscard]] Engine& engine();

}  // namespace velarium::test
