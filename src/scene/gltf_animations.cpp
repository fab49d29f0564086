#include "scene/gltf_parts.hpp"
#include "scene/gltf_transforms.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace velarium::scene::gltf {

namespace {

constexpr std::array kTimeFormats = {Format{Type::scalar, Component::f32}};
constexpr std::array kVectorFormats = {Format{Type::vec3, Component::f32}};

constexpr std::array<Format, 5> floats_or_normalized(Type type) {
  return {Format{type, Component::f32}, Format{type, Component::i8, true}, Format{type, Component::u8, true},
          Format{type, Component::i16, true}, Format{type, Component::u16, true}};
}
constexpr auto kRotationFormats = floats_or_normalized(Type::vec4);
constexpr auto kWeightFormats = floats_or_normalized(Type::scalar);

struct Target {
  std::uint32_t node = 0;
  AnimatedPath path = AnimatedPath::translation;
  std::uint32_t components = 0;  // floats a value
  bool operator<(const Target& other) const { return std::tie(node, path) < std::tie(other.node, other.path); }
};

Interpolation read_interpolation(const Value& value) {
  const std::string name = value.text_or("LINEAR");
  if (name == "LINEAR") return Interpolation::linear;
  if (name == "STEP") return Interpolation::step;
  if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
  value.fail(fmt::format("is '{}', must be LINEAR, STEP or CUBICSPLINE", name));
}

std::optional<AnimatedPath> read_path(const Value& value) {
  const std::string_view name = value.text();
  if (name == "translation") return AnimatedPath::translation;
  if (name == "rotation") return AnimatedPath::rotation;
  if (name == "scale") return AnimatedPath::scale;
  if (name == "weights") return AnimatedPath::weights;
  return std::nullopt;
}

// None for a target that only an extension could explain.
std::optional<Target> read_target(const Context& context, const Value& value) {
  const std::optional<AnimatedPath> path = read_path(value.require("path"));
  const Value node_value = value["node"];
  if (!path || !node_value) {
    value.warn("names no node or an unknown path; the channel is ignored");
    return std::nullopt;
  }
  Target target;
  target.path = *path;
  target.node = node_value.reference(static_cast<std::uint32_t>(context.scene.nodes.size()), "nodes");
  target.components = target.path == AnimatedPath::rotation ? 4 : 3;
  const Node& node = context.scene.nodes[target.node];
  if (target.path == AnimatedPath::weights) {
    target.components = node.mesh == kNone ? 0 : morph_target_count(context, static_cast<std::uint32_t>(node.mesh));
    if (target.components == 0) {
      value.fail(fmt::format("animates weights of node {} without morph targets", target.node));
    }
  } else if (node.matrix) {
    value.fail(fmt::format("animates node {}, whose transform is a matrix", target.node));
  }
  return target;
}

std::vector<float> read_times(Accessors& accessors, const Value& input) {
  std::vector<float> times = accessors.read_floats<float>(accessors.find(input, kTimeFormats));
  if (times.front() < 0.0f) input.fail(fmt::format("starts at {} s, before 0", times.front()));
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] < times[i - 1]) input.fail(fmt::format("time number {} is before the one before it", i));
    if (times[i] == times[i - 1]) input.repair("has keys of one time; the last of them counts");
  }
  return times;
}

// Of keys of one time the last stays.
void drop_repeated_keys(AnimationSampler& sampler) {
  const std::size_t key_values = sampler.values.size() / sampler.times.size();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < sampler.times.size(); ++i) {
    if (i + 1 < sampler.times.size() && sampler.times[i + 1] == sampler.times[i]) continue;
    sampler.times[kept] = sampler.times[i];
    std::copy_n(sampler.values.begin() + static_cast<std::ptrdiff_t>(i * key_values), key_values,
                sampler.values.begin() + static_cast<std::ptrdiff_t>(kept * key_values));
    ++kept;
  }
  sampler.times.resize(kept);
  sampler.values.resize(kept * key_values);
}

template <class Element>
std::vector<float> flattened(const std::vector<Element>& elements) {
  const float* first = glm::value_ptr(elements.front());
  return {first, first + elements.size() * (sizeof(Element) / sizeof(float))};
}

std::vector<float> read_values(Accessors& accessors, const Value& output, AnimatedPath path) {
  switch (path) {
    case AnimatedPath::weights:
      return accessors.read_floats<float>(accessors.find(output, kWeightFormats, Integers::normalized));
    case AnimatedPath::rotation:
      return flattened(
          accessors.read_floats<glm::vec4>(accessors.find(output, kRotationFormats, Integers::normalized)));
    default:
      return flattened(accessors.read_floats<glm::vec3>(accessors.find(output, kVectorFormats)));
  }
}

// Key values alone: tangents of splines have any length.
void normalize_rotations(const Value& output, AnimationSampler& sampler) {
  const bool cubic = sampler.interpolation == Interpolation::cubic_spline;
  for (std::size_t i = cubic ? 4 : 0; i < sampler.values.size(); i += cubic ? 12 : 4) {
    float* key = sampler.values.data() + i;
    const glm::quat unit = unit_rotation(output, {key[0], key[1], key[2], key[3]});
    key[0] = unit.x;
    key[1] = unit.y;
    key[2] = unit.z;
    key[3] = unit.w;
  }
}

AnimationSampler read_sampler(Accessors& accessors, const Value& value, const Target& target) {
  AnimationSampler sampler;
  const Value output = value.require("output");
  sampler.interpolation = read_interpolation(value["interpolation"]);
  sampler.times = read_times(accessors, value.require("input"));
  sampler.values = read_values(accessors, output, target.path);
  sampler.components = target.components;
  const std::size_t per_key = sampler.interpolation == Interpolation::cubic_spline ? 3 : 1;
  const std::size_t needed = sampler.times.size() * per_key * target.components;
  if (sampler.values.size() != needed) {
    output.fail(fmt::format("has {} numbers, must have {}: {} times of {} values of {} components",
                            sampler.values.size(), needed, sampler.times.size(), per_key, target.components));
  }
  if (target.path == AnimatedPath::rotation) normalize_rotations(output, sampler);
  drop_repeated_keys(sampler);
  return sampler;
}

// Reads the channels of one animation, and the samplers that they use.
class AnimationReader {
 public:
  AnimationReader(Context& context, Accessors& accessors, const Value& value)
      : context_(context), accessors_(accessors), value_(value), samplers_(value.require("samplers").elements()) {}

  Animation read() {
    animation_.name = value_["name"].text_or("");
    for (const Value& channel : value_.require("channels").elements()) read_channel(channel);
    for (const AnimationSampler& sampler : animation_.samplers) {
      animation_.duration = std::max(animation_.duration, sampler.times.back());
    }
    return std::move(animation_);
  }

 private:
  void read_channel(const Value& channel) {
    const std::uint32_t sampler =
        channel.require("sampler").reference(static_cast<std::uint32_t>(samplers_.size()), "samplers");
    const Value target_value = channel.require("target");
    const std::optional<Target> target = read_target(context_, target_value);
    if (!target) return;
    if (!targets_.insert(*target).second) target_value.fail("is the target of another channel too; remove one");
    animation_.channels.push_back({sampler_of(sampler, *target), target->node, target->path});
  }

  // The same data means other values on another path, so that a sampler is read once for each kind of use.
  std::uint32_t sampler_of(std::uint32_t index, const Target& target) {
    const auto [entry, is_new] = read_.try_emplace({index, target.path, target.components},
                                                   static_cast<std::uint32_t>(animation_.samplers.size()));
    if (is_new) animation_.samplers.push_back(read_sampler(accessors_, samplers_[index], target));
    return entry->second;
  }

  Context& context_;
  Accessors& accessors_;
  Value value_;
  std::vector<Value> samplers_;
  std::set<Target> targets_;
  std::map<std::tuple<std::uint32_t, AnimatedPath, std::uint32_t>, std::uint32_t> read_;
  Animation animation_;
};

}  // namespace

void read_animations(Context& context, Accessors& accessors) {
  for (const Value& value : context.root["animations"].elements()) {
    context.scene.animations.push_back(AnimationReader(context, accessors, value).read());
  }
}

}  // namespace velarium::scene::gltf
