#include "scene/animation.hpp"

#include <velarium/error.hpp>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace velarium::scene {
namespace {

using Floats = std::vector<float>;

Floats at(const AnimationSampler& sampler, float time, bool is_rotation = false) {
  Floats out(sampler.components);
  sample(sampler, time, is_rotation, out);
  return out;
}

void expect_near(const Floats& a, const Floats& b, float tolerance = 1e-6f) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

// A turn about +Z.
Floats turn(float degrees) {
  return {0, 0, std::sin(0.5f * glm::radians(degrees)), std::cos(0.5f * glm::radians(degrees))};
}

Floats joined(const Floats& a, const Floats& b) {
  Floats out(a);
  out.insert(out.end(), b.begin(), b.end());
  return out;
}

TEST(Animation, StepHoldsTheLastKey) {
  const AnimationSampler s{Interpolation::step, {1, 2, 4}, {10, 20, 40}, 1};
  EXPECT_EQ(at(s, 0.0f), Floats{10});
  EXPECT_EQ(at(s, 1.999f), Floats{10});
  EXPECT_EQ(at(s, 2.0f), Floats{20});
  EXPECT_EQ(at(s, 4.0f), Floats{40});
  EXPECT_EQ(at(s, 9.0f), Floats{40});
}

TEST(Animation, LinearBlendsAndClampsToTheEnds) {
  const AnimationSampler s{Interpolation::linear, {1, 2, 4}, {0, 1, 2, 10, 20, 30, 30, 40, 50}, 3};
  EXPECT_EQ(at(s, 0.0f), (Floats{0, 1, 2}));
  expect_near(at(s, 1.25f), {2.5f, 5.75f, 9});
  expect_near(at(s, 3.0f), {20, 30, 40});
  EXPECT_EQ(at(s, 5.0f), (Floats{30, 40, 50}));
}

TEST(Animation, LinearRotationTurnsAtConstantSpeed) {
  const AnimationSampler s{Interpolation::linear, {0, 3}, joined(turn(0), turn(120)), 4};
  expect_near(at(s, 1.0f, true), turn(40));
  expect_near(at(s, 2.0f, true), turn(80));
}

// q and -q are one rotation; the way between 10 and 50 degrees is by 30, whichever the file stores.
TEST(Animation, LinearRotationTakesTheShorterArc) {
  Floats other = turn(50);
  for (float& x : other) x = -x;
  const AnimationSampler s{Interpolation::linear, {0, 1}, joined(turn(10), other), 4};
  Floats half = at(s, 0.5f, true);
  if (half[3] < 0) {
    for (float& x : half) x = -x;
  }
  expect_near(half, turn(30));
}

TEST(Animation, NearlyEqualRotationsStayUnit) {
  const AnimationSampler s{Interpolation::linear, {0, 1}, joined(turn(10), turn(10.001f)), 4};
  const Floats q = at(s, 0.5f, true);
  EXPECT_NEAR(std::hypot(q[2], q[3]), 1.0f, 1e-6f);
}

// A cubic that a Hermite spline must give back exactly: f(t) = t^3 - 2 t, f' = 3 t^2 - 2, keys at 1 and 3.
TEST(Animation, CubicSplineReproducesACubic) {
  const auto f = [](float t) { return t * t * t - 2 * t; };
  const auto slope = [](float t) { return 3 * t * t - 2; };
  const AnimationSampler s{Interpolation::cubic_spline, {1, 3}, {99, f(1), slope(1), slope(3), f(3), 99}, 1};
  for (const float t : {1.0f, 1.5f, 2.0f, 2.25f, 3.0f}) expect_near(at(s, t), {f(t)}, 1e-5f);
  EXPECT_EQ(at(s, 0.0f), Floats{f(1)});
  EXPECT_EQ(at(s, 7.0f), Floats{f(3)});
}

TEST(Animation, CubicSplineOfRotationsIsNormalised) {
  Floats values;
  for (const float degrees : {0.0f, 90.0f}) {
    values = joined(values, joined(Floats{0, 0, 0, 0}, joined(turn(degrees), Floats{0, 0, 0, 0})));
  }
  const AnimationSampler s{Interpolation::cubic_spline, {0, 1}, values, 4};
  expect_near(at(s, 0.5f, true), turn(45));  // with flat tangents the middle is the mean, by symmetry 45 degrees
}

Scene scene_with_animations() {
  Scene scene;
  scene.source = "test";
  scene.nodes.resize(2);
  scene.nodes[0].translation = {7, 7, 7};
  const AnimationSampler move{Interpolation::linear, {0, 1}, {0, 0, 0, 2, 0, 0}, 3};
  const AnimationSampler grow{Interpolation::linear, {0, 1}, {1, 1, 1, 3, 3, 3}, 3};
  scene.animations.push_back({"move", {move}, {{0, 0, AnimatedPath::translation}}, 1});
  scene.animations.push_back({"grow", {grow}, {{0, 1, AnimatedPath::scale}}, 1});
  return scene;
}

TEST(Animation, ChoiceIsByNameOrIndexOrAllOrTheFirst) {
  const Scene scene = scene_with_animations();
  const auto x_and_scale = [&](const std::string& choice) {
    const auto poses = poses_at(scene, 0.5f, choice);
    return Floats{static_cast<float>(poses[0].translation.x), poses[1].scale.x};
  };
  expect_near(x_and_scale(""), {1, 1});
  expect_near(x_and_scale("move"), {1, 1});
  expect_near(x_and_scale("grow"), {7, 2});
  expect_near(x_and_scale("1"), {7, 2});
  expect_near(x_and_scale("all"), {1, 2});
}

TEST(Animation, AnUnknownChoiceListsThoseThereAre) {
  for (const char* choice : {"mov", "2", "-1", "1x"}) {
    try {
      (void)poses_at(scene_with_animations(), 0.0f, choice);
      FAIL() << choice;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::usage);
      EXPECT_NE(std::string(error.what()).find("move"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("grow"), std::string::npos);
    }
  }
}

TEST(Animation, WithoutAnimationsEveryNodeRests) {
  Scene scene = scene_with_animations();
  scene.animations.clear();
  for (const char* choice : {"", "all"}) EXPECT_EQ(poses_at(scene, 0.5f, choice)[0].translation, glm::dvec3(7));
}

TEST(Animation, MorphWeightsComeFromTheAnimationTheNodeOrTheMesh) {
  Scene scene;
  scene.meshes.push_back({"m", {}, {0.25f, 0.5f}});
  scene.nodes.resize(3);
  for (Node& node : scene.nodes) node.mesh = 0;
  scene.nodes[1].weights = {1, 0};
  const AnimationSampler s{Interpolation::linear, {0, 1}, {0, 1, 1, 0}, 2};
  scene.animations.push_back({"a", {s}, {{0, 2, AnimatedPath::weights}}, 1});
  const auto poses = poses_at(scene, 0.25f, "");
  expect_near(poses[0].weights, {0.25f, 0.5f});
  expect_near(poses[1].weights, {1, 0});
  expect_near(poses[2].weights, {0.25f, 0.75f});
}

}  // namespace
}  // namespace velarium::scene
