#pragma once

#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace velarium::scene {

// Scenes made by code, deterministic, needing no file.
[[nodiscard]] std::vector<std::string> builtin_names();

// Throws Error(input_missing) that lists the names there are. `name` has no "builtin:" prefix.
[[nodiscard]] Scene builtin_scene(const std::string& name);

}  // namespace velarium::scene
