#include "scene/animation.hpp"

#include <velarium/error.hpp>

#include "core/assert.hpp"
#include "scene/choice.hpp"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>

namespace velarium::scene {
namespace {

glm::quat quat_of(std::span<const float> xyzw) {
  return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]};
}

void store(const glm::quat& q, std::span<float> out) {
  out[0] = q.x;
  out[1] = q.y;
  out[2] = q.z;
  out[3] = q.w;
}

// A quaternion of no length names no rotation.
glm::quat unit(const glm::quat& q) {
  const float length = glm::length(q);
  return length > 0.0f ? q / length : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
}

// The parts of a keyframe, which a cubic spline stores one after the other.
enum class Part : std::size_t { in_tangent = 0, value = 1, out_tangent = 2 };

std::span<const float> part_of(const AnimationSampler& sampler, std::size_t key, Part part) {
  const std::size_t n = sampler.components;
  const std::size_t place =
      sampler.interpolation == Interpolation::cubic_spline ? 3 * key + static_cast<std::size_t>(part) : key;
  return std::span(sampler.values).subspan(place * n, n);
}

// Appendix C.4: Hermite spline; the stored tangents are per second.
void sample_cubic(const AnimationSampler& sampler, std::size_t key, float t, float seconds, std::span<float> out) {
  const float t2 = t * t, t3 = t2 * t;
  const auto v0 = part_of(sampler, key, Part::value), v1 = part_of(sampler, key + 1, Part::value);
  const auto leaving = part_of(sampler, key, Part::out_tangent);
  const auto arriving = part_of(sampler, key + 1, Part::in_tangent);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = (2.0f * t3 - 3.0f * t2 + 1.0f) * v0[i] + seconds * (t3 - 2.0f * t2 + t) * leaving[i] +
             (-2.0f * t3 + 3.0f * t2) * v1[i] + seconds * (t3 - t2) * arriving[i];
  }
}

// Appendix C.2 and C.3. glm's slerp takes the shorter arc.
void sample_linear(const AnimationSampler& sampler, std::size_t key, float t, bool is_rotation, std::span<float> out) {
  const auto v0 = part_of(sampler, key, Part::value), v1 = part_of(sampler, key + 1, Part::value);
  if (is_rotation) return store(glm::slerp(unit(quat_of(v0)), unit(quat_of(v1)), t), out);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = (1.0f - t) * v0[i] + t * v1[i];
}

void apply(const AnimationSampler& sampler, AnimatedPath path, float time_s, Pose& pose) {
  if (path == AnimatedPath::weights) {
    pose.weights.resize(sampler.components);
    return sample(sampler, time_s, false, pose.weights);
  }
  std::array<float, 4> value{};
  const bool is_rotation = path == AnimatedPath::rotation;
  VEL_ASSERT(sampler.components == (is_rotation ? 4u : 3u));
  sample(sampler, time_s, is_rotation, std::span(value).first(sampler.components));
  const glm::vec3 xyz(value[0], value[1], value[2]);
  if (path == AnimatedPath::translation) pose.translation = xyz;
  if (path == AnimatedPath::scale) pose.scale = xyz;
  if (is_rotation) pose.rotation = quat_of(value);
}

Pose rest_pose(const Scene& scene, const Node& node) {
  Pose pose{node.translation, node.rotation, node.scale, node.weights};
  if (pose.weights.empty() && node.mesh != kNone)
    pose.weights = scene.meshes[static_cast<std::size_t>(node.mesh)].weights;
  return pose;
}

std::vector<const Animation*> chosen(const Scene& scene, const std::string& choice) {
  std::vector<const Animation*> out;
  if (choice == "none") return {};
  if (choice == "all") {
    for (const Animation& animation : scene.animations) out.push_back(&animation);
    return out;
  }
  if (choice.empty()) {
    if (!scene.animations.empty()) out.push_back(&scene.animations.front());
    return out;
  }
  std::vector<std::string> names;
  for (const Animation& animation : scene.animations) names.push_back(animation.name);
  const auto found = find_choice(names, choice);
  if (!found) throw Error(ErrorCode::usage, scene.source, unknown_choice("animation", names, choice, "all, none"));
  out.push_back(&scene.animations[*found]);
  return out;
}

}  // namespace

void sample(const AnimationSampler& sampler, float time_s, bool is_rotation, std::span<float> out) {
  VEL_ASSERT(!sampler.times.empty() && out.size() == sampler.components);
  const auto& times = sampler.times;
  const auto after = std::upper_bound(times.begin(), times.end(), time_s);
  const std::size_t key = after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
  if (after == times.begin() || after == times.end() || sampler.interpolation == Interpolation::step) {
    std::ranges::copy(part_of(sampler, key, Part::value), out.begin());
  } else {
    const float seconds = times[key + 1] - times[key];
    const float t = (time_s - times[key]) / seconds;
    if (sampler.interpolation == Interpolation::cubic_spline) {
      sample_cubic(sampler, key, t, seconds, out);
    } else {
      sample_linear(sampler, key, t, is_rotation, out);
    }
  }
  if (is_rotation) store(unit(quat_of(out)), out);
}

std::vector<Pose> poses_at(const Scene& scene, float time_s, const std::string& animation) {
  std::vector<Pose> poses;
  poses.reserve(scene.nodes.size());
  for (const Node& node : scene.nodes) poses.push_back(rest_pose(scene, node));
  for (const Animation* played : chosen(scene, animation)) {
    for (const AnimationChannel& channel : played->channels) {
      apply(played->samplers[channel.sampler], channel.path, time_s, poses[channel.node]);
    }
  }
  return poses;
}

}  // namespace velarium::scene
