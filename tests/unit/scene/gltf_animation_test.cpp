#include "gltf_model.hpp"

namespace velarium::scene::test {
namespace {

// Node 0 animated on `path` at the times given, from accessor `output`.
Model animated(const char* path, const std::vector<float>& times, const std::function<int(Model&)>& output,
               const char* interpolation = "LINEAR") {
  Model model = triangle();
  const int input = model.add<float>("SCALAR", kFloat, times.size(), times);
  const Json sampler = {{"input", input}, {"output", output(model)}, {"interpolation", interpolation}};
  const Json channel = {{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}};
  model.root["animations"] = {{{"name", "a"}, {"samplers", {sampler}}, {"channels", {channel}}}};
  return model;
}

std::function<int(Model&)> vectors(std::size_t count) {
  return [count](Model& model) {
    std::vector<float> values(count * 3);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
    return model.add<float>("VEC3", kFloat, count, values);
  };
}

TEST(GltfAnimation, TranslationAndScale) {
  for (const auto& [path, expected] :
       {std::pair{"translation", AnimatedPath::translation}, {"scale", AnimatedPath::scale}}) {
    const Scene scene = read(animated(path, {0.5f, 2}, vectors(2)));
    const Animation& animation = scene.animations.at(0);
    EXPECT_EQ(animation.name, "a");
    EXPECT_EQ(animation.duration, 2.0f);
    ASSERT_EQ(animation.channels.size(), 1u);
    EXPECT_EQ(animation.channels[0].path, expected);
    EXPECT_EQ(animation.channels[0].node, 0u);
    const AnimationSampler& sampler = animation.samplers.at(animation.channels[0].sampler);
    EXPECT_EQ(sampler.interpolation, Interpolation::linear);
    EXPECT_EQ(sampler.times, (std::vector<float>{0.5f, 2}));
    EXPECT_EQ(sampler.values, (std::vector<float>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(sampler.components, 3u);
  }
}

TEST(GltfAnimation, Interpolations) {
  EXPECT_EQ(read(animated("scale", {0, 1}, vectors(2), "STEP")).animations.at(0).samplers.at(0).interpolation,
            Interpolation::step);
  const Scene cubic = read(animated("scale", {0, 1}, vectors(6), "CUBICSPLINE"));
  EXPECT_EQ(cubic.animations.at(0).samplers.at(0).interpolation, Interpolation::cubic_spline);
  EXPECT_EQ(cubic.animations.at(0).samplers.at(0).values.size(), 18u);
  expect_refused(animated("scale", {0, 1}, vectors(2), "HERMITE"),
                 "/animations/0/samplers/0/interpolation: is 'HERMITE'");
}

TEST(GltfAnimation, RotationsAreUnitAlsoFromIntegers) {
  const auto rotation = [](const std::function<int(Model&)>& output, const char* interpolation = "LINEAR") {
    return read(animated("rotation", {0}, output, interpolation));
  };
  const Scene bytes = rotation([](Model& m) { return m.add<std::int8_t>("VEC4", kByte, 1, {0, 90, 0, 90}, true); });
  EXPECT_NEAR(bytes.animations.at(0).samplers.at(0).values.at(1), 0.70710678f, 1e-6f);
  const Scene shorts = rotation([](Model& m) {
    return m.add<std::uint16_t>("VEC4", kUnsignedShort, 1, {65535, 0, 0, 0}, true);
  });
  EXPECT_EQ(shorts.animations.at(0).samplers.at(0).values, (std::vector<float>{1, 0, 0, 0}));
  // The tangents of a spline keep their length, also where it is 0.
  const Scene cubic = rotation(
      [](Model& m) {
        return m.add<float>("VEC4", kFloat, 3, {0, 0, 0, 0, 0, 0, 0, 2, 5, 0, 0, 0});
      },
      "CUBICSPLINE");
  EXPECT_EQ(cubic.animations.at(0).samplers.at(0).values, (std::vector<float>{0, 0, 0, 0, 0, 0, 0, 1, 5, 0, 0, 0}));
  EXPECT_TRUE(has_warning(cubic, "/animations/0/samplers/0/output: a rotation is not of unit length"));
  expect_refused(animated("rotation", {0},
                          [](Model& m) {
                            return m.add<float>("VEC4", kFloat, 1, {0, 0, 0, 0});
                          }),
                 "/animations/0/samplers/0/output: a rotation is a quaternion of length 0");
}

TEST(GltfAnimation, WeightsHaveOneComponentAMorphTarget) {
  Model model = animated("weights", {0, 1}, [](Model& m) {
    return m.add<std::uint8_t>("SCALAR", kUnsignedByte, 4, {0, 255, 51, 0}, true);
  });
  model.primitive()["targets"] = {{{"POSITION", 0}}, {{"POSITION", 0}}};
  const Scene scene = read(model);
  EXPECT_EQ(scene.animations.at(0).samplers.at(0).components, 2u);
  EXPECT_EQ(scene.animations.at(0).samplers.at(0).values, (std::vector<float>{0, 1, 0.2f, 0}));
  model.primitive().erase("targets");
  expect_refused(model, "/animations/0/channels/0/target: animates weights of node 0 without morph targets");
}

TEST(GltfAnimation, CountsAndFormatsAgree) {
  expect_refused(animated("scale", {0, 1}, vectors(3)), "/animations/0/samplers/0/output: has 9 numbers, must have 6");
  expect_refused(animated("scale", {0, 1}, vectors(2), "CUBICSPLINE"),
                 "/animations/0/samplers/0/output: has 6 numbers, must have 18");
  expect_refused(animated("rotation", {0, 1}, vectors(2)),
                 "/animations/0/samplers/0/output: is an accessor of VEC3 FLOAT");
}

TEST(GltfAnimation, TimesIncrease) {
  expect_refused(animated("scale", {1, 0.5f}, vectors(2)), "/animations/0/samplers/0/input: time number 1");
  expect_refused(animated("scale", {-1, 0.5f}, vectors(2)), "/animations/0/samplers/0/input: starts at -1 s");
}

TEST(GltfAnimation, OfKeysOfOneTimeTheLastStays) {
  const Scene scene = expect_repaired(animated("scale", {0, 1, 1, 1, 2}, vectors(5)),
                                      "/animations/0/samplers/0/input: has keys of one time");
  const AnimationSampler& sampler = scene.animations.at(0).samplers.at(0);
  EXPECT_EQ(sampler.times, (std::vector<float>{0, 1, 2}));
  const std::vector<float> wanted{0, 1, 2, 9, 10, 11, 12, 13, 14};
  EXPECT_EQ(sampler.values, wanted);
}

TEST(GltfAnimation, TargetsAreChecked) {
  Model model = animated("scale", {0, 1}, vectors(2));
  Json& animation = model.root["animations"][0];
  animation["channels"].push_back(animation["channels"][0]);
  expect_refused(model, "/animations/0/channels/1/target: is the target of another channel too");
  animation["channels"][1]["target"]["path"] = "translation";
  const Scene scene = read(model);
  EXPECT_EQ(scene.animations.at(0).channels.size(), 2u);
  animation["channels"][1]["target"]["node"] = 1;
  expect_refused(model, "/animations/0/channels/1/target/node: is 1, but there are 1 nodes");
  animation["channels"][1]["sampler"] = 5;
  expect_refused(model, "/animations/0/channels/1/sampler: is 5, but there are 1 samplers");
  model = animated("scale", {0, 1}, vectors(2));
  model.root["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  expect_refused(model, "/animations/0/channels/0/target: animates node 0, whose transform is a matrix");
}

TEST(GltfAnimation, TargetsOfExtensionsAreIgnoredWithAWarning) {
  Model model = animated("pointer", {0, 1}, vectors(2));
  const Scene scene = read(model);
  EXPECT_TRUE(scene.animations.at(0).channels.empty());
  EXPECT_TRUE(has_warning(scene, "/animations/0/channels/0/target: names no node or an unknown path"));
  model.root["animations"][0]["channels"][0]["target"] = {{"path", "scale"}};
  EXPECT_TRUE(has_warning(read(model), "names no node"));
}

}  // namespace
}  // namespace velarium::scene::test
