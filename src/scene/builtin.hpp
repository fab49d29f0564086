#pragma once

#include "scene/scene.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace velarium::scene {

// What a built-in scene takes: a whole number, "terrain?triangles=20000", or a name that stands for one,
// "boxes?light=spot".
struct BuiltinParameter {
  std::string key;
  std::uint32_t value = 0;  // the one asked for, else the default
  std::uint32_t least = 0, most = 0;
  std::string meaning;
  std::vector<std::string> names;  // of the values from 0 on; empty: numbers are written
};

// Scenes made by code, deterministic, needing no file. Names without parameters.
[[nodiscard]] std::vector<std::string> builtin_names();

// `name` has no "builtin:" prefix, and may end in "?key=value&key=value". Both throw Error(input_missing) that lists
// the names there are, and Error(usage) that lists the keys and their ranges where one is wrong.
[[nodiscard]] Scene builtin_scene(const std::string& name);
[[nodiscard]] std::vector<BuiltinParameter> builtin_parameters(const std::string& name);

}  // namespace velarium::scene
