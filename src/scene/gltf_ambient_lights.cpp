// Volumes in which environment light is multiplied. The extras of a node make one: {"ambient_light": {"color": [0.4,
// 0.4, 0.5], "range": 3}} is a sphere about its origin. docs/lights.md and docs/ambient_light_extras.schema.json
// describe them.

#include "scene/gltf_parts.hpp"

#include <fmt/core.h>

namespace velarium::scene::gltf {

namespace {

// Each lit point asks each one that the view sees.
constexpr std::size_t kMostAmbientLights = 256;

// Far above what brightens a room that its environment leaves dark, far below where products of a few leave half
// floats.
constexpr float kBrightestChannel = 16.0f;

// Extras belong to applications and may be anything, so what does not fit is left out with a warning: false then.
bool ignore(const Value& value, const std::string& reason) {
  value.warn(reason + "; it is ignored");
  return false;
}

bool take_color(const Value& value, glm::vec3& color) {
  const bool is_list = value.is_array() && value.size() == 3;
  for (std::uint32_t channel = 0; channel < 3; ++channel) {
    const float number = is_list && value.at(channel).is_number() ? value.at(channel).number() : -1.0f;
    if (!(number >= 0.0f && number <= kBrightestChannel))
      return ignore(value, fmt::format("is not three numbers from 0 to {}", kBrightestChannel));
    color[static_cast<int>(channel)] = number;
  }
  return true;
}

bool take_range(const Value& value, float& range) {
  range = value.is_number() ? value.number() : 0.0f;
  return range > 0.0f || ignore(value, "is not a number of metres above 0");
}

void read_ambient_light(const Value& value, Scene& scene, std::uint32_t node) {
  if (!value.is_object()) return;
  AmbientLight light{.node = node};
  const Value color = value["color"], range = value["range"];
  if (!color || !range) return void(ignore(value, "has no color or no range"));
  if (!take_color(color, light.color) || !take_range(range, light.range)) return;
  if (scene.ambient_lights.size() == kMostAmbientLights)
    return void(ignore(value, fmt::format("is one of more than {} ambient lights", kMostAmbientLights)));
  scene.ambient_lights.push_back(light);
}

}  // namespace

void read_ambient_lights(Context& context) {
  const Value nodes = context.root["nodes"];
  for (std::uint32_t i = 0; i < context.scene.nodes.size(); ++i)
    read_ambient_light(nodes.at(i).extra_member("ambient_light"), context.scene, i);
}

}  // namespace velarium::scene::gltf
