#include "scene/gltf_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace velarium::scene::gltf {

namespace {

constexpr float kAnyPositive = std::numeric_limits<float>::max();
constexpr float kPi = std::numbers::pi_v<float>;
constexpr double kDefaultOuterCone = std::numbers::pi / 4.0;

float positive(const Value& value) {
  const float number = value.number();
  if (!(number > 0.0f)) value.fail(fmt::format("is {}, must be more than 0", number));
  return number;
}

LightKind read_light_kind(const Value& value) {
  const std::string_view type = value.text();
  if (type == "directional") return LightKind::directional;
  if (type == "point") return LightKind::point;
  if (type == "spot") return LightKind::spot;
  value.fail(fmt::format("is '{}', must be directional, point or spot", type));
}

// 0, which the specification forbids, has always meant what leaving it out means.
float read_range(const Value& value) {
  if (!value || value.number() > 0.0f) return value.number_or(0.0f);
  value.repair(fmt::format("is {}, must be more than 0; the light has no end", value.number()));
  return 0.0f;
}

void read_cones(const Value& spot, Light& light) {
  constexpr float kWidest = kPi / 2.0f;
  const Value inner = spot["innerConeAngle"], outer = spot["outerConeAngle"];
  if (outer) light.outer_cone = positive(outer);
  if (light.outer_cone > kWidest) outer.fail("must be at most pi/2 radians");
  light.inner_cone = inner.clamped_or(light.inner_cone, 0.0f, kWidest);
  // As the file writes them: a hard cone's angles may differ by less than floats do.
  if (!(inner.double_or(0.0) < outer.double_or(kDefaultOuterCone)))
    (outer ? outer : inner).repair("does not exceed the other cone's angle; the cone is hard");
  light.inner_cone = std::min(light.inner_cone, light.outer_cone);
}

// --- extras -------------------------------------------------------------------------------------------------------
//
// docs/lights.md and docs/light_extras.schema.json describe them. Extras belong to applications and may be anything, so
// what does not fit is left out with a warning.

void ignore(const Value& value, std::string_view expected) {
  value.warn(fmt::format("is not {}; it is ignored", expected));
}

// Between the limits, these left out.
void take_open(const Value& value, float above, float below, std::string_view expected, float& target) {
  if (!value) return;
  const float number = value.is_number() ? value.number() : above;
  if (!(number > above && number < below)) return ignore(value, expected);
  target = number;
}

void take_share(const Value& value, float& target) {
  if (!value) return;
  const float number = value.is_number() ? value.number() : -1.0f;
  if (!(number >= 0.0f && number <= 1.0f)) return ignore(value, "a number from 0 to 1");
  target = number;
}

void take_metres(const Value& value, float& target) {
  take_open(value, 0.0f, kAnyPositive, "a number of metres above 0", target);
}

void take_falloff(const Value& value, Falloff& target) {
  if (!value) return;
  const std::string_view text = value.is_text() ? value.text() : std::string_view();
  if (text != "inverse_square" && text != "bulb") return ignore(value, "inverse_square or bulb");
  target = text == "bulb" ? Falloff::bulb : Falloff::inverse_square;
}

// Into /images: an index, or the uri of one of them; kNone where it is neither.
std::int32_t image_of(const Context& context, const Value& value) {
  const Value images = context.root["images"];
  const std::uint32_t count = images.size();
  for (std::uint32_t i = 0; i < count; ++i) {
    const Value uri = images.at(i)["uri"];
    const bool is_named = value.is_text() && uri.is_text() && uri.text() == value.text();
    const bool is_numbered = value.is_number() && value.number() == static_cast<float>(i);
    if (is_named || is_numbered) return static_cast<std::int32_t>(i);
  }
  return kNone;
}

void read_projector(const Context& context, const Value& value, Light& light) {
  if (!value) return;
  if (light.kind != LightKind::spot) return value.warn("belongs to a light that is no spot; it is ignored");
  if (!value.is_object()) return ignore(value, "an object");
  Projector& projector = light.projector;
  projector.image = image_of(context, value["image"]);
  if (!projector.present()) return value.warn("its image is no index or uri of /images; it is ignored");
  projector.field_of_view = 2.0f * light.outer_cone;
  take_open(value["field_of_view"], 0.0f, kPi, "a number of radians above 0 and below pi", projector.field_of_view);
  take_share(value["soft_edge"], projector.soft_edge);
}

void read_bulb(const Value& value, Light& light) {
  take_metres(value.extra_member("radius"), light.radius);
  const Value falloff = value.extra_member("falloff"), cutoff = value.extra_member("cutoff");
  take_falloff(falloff, light.falloff);
  if (light.falloff == Falloff::bulb && light.radius == 0.0f) {
    falloff.warn("needs a radius beside it; the light falls off by the inverse square");
    light.falloff = Falloff::inverse_square;
  }
  if (cutoff && light.falloff != Falloff::bulb) return cutoff.warn("belongs to the falloff bulb; it is ignored");
  take_metres(cutoff, light.range);
}

void read_light_extras(const Context& context, const Value& value, Light& light) {
  const Value casts_shadow = value.extra_member("casts_shadow");
  if (casts_shadow.is_boolean())
    light.casts_shadow = casts_shadow.boolean_or(true);
  else if (casts_shadow)
    ignore(casts_shadow, "true or false");
  if (light.kind == LightKind::directional) {
    take_open(value.extra_member("angular_radius"), 0.0f, kPi / 2.0f, "a number of radians above 0 and below pi/2",
              light.angular_radius);
  } else {
    read_bulb(value, light);
  }
  read_projector(context, value.extra_member("projector"), light);
}

Light read_light(const Context& context, const Value& value) {
  Light light;
  light.name = value["name"].text_or("");
  light.kind = read_light_kind(value.require("type"));
  light.color = value["color"].clamped_vector_or(light.color, 0.0f, kAnyPositive);
  light.intensity = value["intensity"].clamped_or(light.intensity, 0.0f, kAnyPositive);
  light.range = read_range(value["range"]);
  if (light.kind == LightKind::spot) read_cones(value.require("spot"), light);
  read_light_extras(context, value, light);
  return light;
}

}  // namespace

void read_lights_punctual(Context& context, const Value& extension) {
  for (const Value& value : extension.require("lights").elements())
    context.scene.lights.push_back(read_light(context, value));
}

void read_node_light(Context& context, const Value& extension, Node& node) {
  const auto count = static_cast<std::uint32_t>(context.scene.lights.size());
  node.light = static_cast<std::int32_t>(extension.require("light").reference(count, "lights"));
}

}  // namespace velarium::scene::gltf
