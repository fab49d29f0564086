#include "scene/builtin.hpp"

#include <velarium/error.hpp>

#include "scenes/scenes.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>

namespace velarium::scene {
namespace {

struct Entry {
  const char* name;
  Scene (*make)();
};

constexpr std::array<Entry, 4> kEntries{{
    {"atrium", atrium_scene},
    {"spheres", spheres_scene},
    {"furnace", furnace_scene},
    {"cornell", cornell_scene},
}};

}  // namespace

std::vector<std::string> builtin_names() {
  std::vector<std::string> names;
  for (const Entry& entry : kEntries) names.emplace_back(entry.name);
  return names;
}

Scene builtin_scene(const std::string& name) {
  for (const Entry& entry : kEntries) {
    if (entry.name == name) return entry.make();
  }
  throw Error(ErrorCode::input_missing, "builtin:" + name,
              fmt::format("no such scene; there are: {}", fmt::join(builtin_names(), ", ")));
}

}  // namespace velarium::scene
