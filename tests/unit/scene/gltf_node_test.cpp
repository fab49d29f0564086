#include "gltf_model.hpp"

#include <cmath>
#include <numbers>

namespace velarium::scene::test {
namespace {

Model with_nodes(const char* nodes) {
  Model model;
  model.root["nodes"] = Json::parse(nodes);
  return model;
}

TEST(GltfNode, TransformsAreKept) {
  const Scene scene = read(with_nodes(R"([
    {"name": "moved", "translation": [1, 2, 3], "rotation": [0, 1, 0, 0], "scale": [-1, 2, 0.5]},
    {"matrix": [1,0,0,0, 0,2,0,0, 0,0,3,0, 4,5,6,1]}, {}])"));
  const Node& moved = scene.nodes.at(0);
  EXPECT_EQ(moved.name, "moved");
  EXPECT_EQ(moved.translation, glm::dvec3(1, 2, 3));
  EXPECT_EQ(moved.rotation, glm::quat(0, 0, 1, 0));  // glm's order is w, x, y, z
  EXPECT_EQ(moved.scale, glm::vec3(-1, 2, 0.5f));
  ASSERT_TRUE(scene.nodes.at(1).matrix.has_value());
  EXPECT_EQ((*scene.nodes.at(1).matrix)[3], glm::dvec4(4, 5, 6, 1));
  EXPECT_FALSE(scene.nodes.at(2).matrix.has_value());
}

TEST(GltfNode, TransformsAreChecked) {
  const Scene scaled = read(with_nodes(R"([{"rotation": [0, 0, 0, 2]}])"));
  EXPECT_EQ(scaled.nodes.at(0).rotation, glm::quat(1, 0, 0, 0));
  EXPECT_TRUE(has_warning(scaled, "/nodes/0/rotation: a rotation is not of unit length"));
  expect_refused(with_nodes(R"([{"rotation": [0, 0, 0, 0]}])"),
                 "/nodes/0/rotation: a rotation is a quaternion of length 0");
  expect_refused(with_nodes(R"([{"scale": [1, 1]}])"), "/nodes/0/scale: has 2 numbers, must have 3");
  expect_refused(with_nodes(R"([{"translation": [1e39, 0, 0]}])"), "/nodes/0/translation/0: is 1e+39, which exceeds");
  expect_refused(with_nodes(R"([{"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "scale": [1, 1, 1]}])"),
                 "/nodes/0/matrix: stands beside");
  expect_refused(with_nodes(R"([{"matrix": [1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}])"), "/nodes/0/matrix: element 3");
}

TEST(GltfNode, ParentsAndChildren) {
  const Scene scene = read(with_nodes(R"([{"children": [2, 1]}, {}, {"children": [3]}, {}])"));
  EXPECT_EQ(scene.nodes.at(0).children, (std::vector<std::uint32_t>{2, 1}));
  EXPECT_EQ(scene.nodes.at(0).parent, kNone);
  EXPECT_EQ(scene.nodes.at(3).parent, 2);
}

TEST(GltfNode, OnlyForestsAreAccepted) {
  expect_refused(with_nodes(R"([{"children": [0]}])"), "/nodes/0: is part of a loop");
  expect_refused(with_nodes(R"([{}, {"children": [2]}, {"children": [3]}, {"children": [1]}])"),
                 "/nodes/1: is part of a loop");
  expect_refused(with_nodes(R"([{"children": [2]}, {"children": [2]}, {}])"),
                 "/nodes/1/children/0: node 2 is already a child of node 0");
  expect_refused(with_nodes(R"([{"children": [1, 1]}, {}])"), "/nodes/0/children/1: node 1 is already a child");
  expect_refused(with_nodes(R"([{"children": [1]}])"), "/nodes/0/children/0: is 1, but there are 1 nodes");
}

Model chain(std::size_t length) {
  Model model;
  for (std::size_t i = 1; i < length; ++i) model.root["nodes"].push_back({{"children", {i}}});
  model.root["nodes"].push_back(Json::object());
  return model;
}

TEST(GltfNode, DepthAndNumberAreBounded) {
  EXPECT_NO_THROW(static_cast<void>(read(chain(256))));
  expect_refused(
      chain(257),
      "/nodes/256: lies at a depth of 257 levels, more than load.depth=256 allows; -D load.depth=257 allows it");
  GltfOptions options;
  options.limits.depth = 257;
  EXPECT_NO_THROW(static_cast<void>(read(chain(257), options)));
  options.limits.nodes = 3;
  expect_refused(chain(4), "/nodes: has 4 nodes, more than load.nodes=3 allows; -D load.nodes=4 allows it", options);
  EXPECT_NO_THROW(static_cast<void>(read(chain(3), options)));
}

TEST(GltfNode, ReferencesAreChecked) {
  expect_refused(with_nodes(R"([{"mesh": 0}])"), "/nodes/0/mesh: is 0, but there are 0 meshes");
  expect_refused(with_nodes(R"([{"camera": 2}])"), "/nodes/0/camera: is 2, but there are 0 cameras");
  expect_refused(with_nodes(R"([{"mesh": -1}])"), "/nodes/0/mesh: is -1");
  expect_refused(with_nodes(R"([{"mesh": 0.5}])"), "/nodes/0/mesh: is 0.5");
}

TEST(GltfScenes, TheNamedOneElseTheFirstElseAllRoots) {
  Model model = with_nodes(R"([{"children": [3]}, {}, {}, {}])");
  EXPECT_EQ(read(model).roots, (std::vector<std::uint32_t>{0, 1, 2}));
  model.root["scenes"] = Json::parse(R"([{"nodes": [1]}, {"nodes": [2, 0]}, {}])");
  EXPECT_EQ(read(model).roots, (std::vector<std::uint32_t>{1}));
  model.root["scene"] = 1;
  EXPECT_EQ(read(model).roots, (std::vector<std::uint32_t>{2, 0}));
  model.root["scene"] = 2;
  EXPECT_TRUE(read(model).roots.empty());
  model.root["scene"] = 3;
  expect_refused(model, "/scene: is 3, but there are 3 scenes");
}

TEST(GltfScenes, RootsAreChecked) {
  Model model = with_nodes(R"([{"children": [1]}, {}])");
  model.root["scenes"] = Json::parse(R"([{"nodes": [0]}, {"nodes": [0, 1]}])");
  expect_refused(model, "/scenes/1/nodes/1: node 1 is a child of node 0, not a root");
  model.root["scenes"] = Json::parse(R"([{"nodes": [0]}, {"nodes": [0, 0]}])");
  expect_refused(model, "/scenes/1/nodes/1: node 0 is listed twice");
  model.root["scenes"] = Json::parse(R"([{"nodes": [2]}])");
  expect_refused(model, "/scenes/0/nodes/0: is 2, but there are 2 nodes");
}

// --- cameras ----------------------------------------------------------------------------------------------------

Model with_camera(const char* camera) {
  Model model;
  model.root["cameras"] = {Json::parse(camera)};
  return model;
}

TEST(GltfCamera, PerspectiveFiniteAndInfinite) {
  const Camera finite = read(with_camera(R"({"name": "c", "type": "perspective", "perspective":
    {"yfov": 0.5, "aspectRatio": 1.5, "znear": 0.01, "zfar": 100}})"))
                            .cameras.at(0);
  EXPECT_EQ(finite.name, "c");
  EXPECT_EQ(finite.kind, Camera::Kind::perspective);
  EXPECT_EQ(finite.vertical_fov, 0.5f);
  EXPECT_EQ(finite.aspect, 1.5f);
  EXPECT_EQ(finite.z_near, 0.01f);
  EXPECT_EQ(finite.z_far, 100.0f);
  const Camera infinite =
      read(with_camera(R"({"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.01}})")).cameras.at(0);
  EXPECT_FALSE(infinite.aspect.has_value());
  EXPECT_TRUE(std::isinf(infinite.z_far));
}

TEST(GltfCamera, Orthographic) {
  const Scene scene =
      read(with_camera(R"({"type": "orthographic", "orthographic": {"xmag": 2, "ymag": -3, "znear": 0, "zfar": 10}})"));
  EXPECT_EQ(scene.cameras.at(0).kind, Camera::Kind::orthographic);
  EXPECT_EQ(scene.cameras.at(0).half_size, glm::vec2(2, 3));
  EXPECT_EQ(scene.cameras.at(0).z_near, 0.0f);
  EXPECT_TRUE(has_warning(scene, "/cameras/0/orthographic/ymag: is negative"));
}

TEST(GltfCamera, WrongOnesAreRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({})", "/cameras/0: has no property 'type'"},
      {R"({"type": "fisheye"})", "/cameras/0/type: is 'fisheye'"},
      {R"({"type": "perspective"})", "/cameras/0: has no property 'perspective'"},
      {R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 1}, "orthographic": {}})",
       "/cameras/0: has both"},
      {R"({"type": "perspective", "perspective": {"yfov": 0, "znear": 1}})", "/cameras/0/perspective/yfov: is 0"},
      {R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 0}})", "/cameras/0/perspective/znear: is 0"},
      {R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 1, "zfar": 1}})",
       "/cameras/0/perspective: zfar must be more than znear"},
      {R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 1, "aspectRatio": 0}})",
       "/cameras/0/perspective/aspectRatio: is 0"},
      {R"({"type": "orthographic", "orthographic": {"xmag": 0, "ymag": 1, "znear": 0, "zfar": 1}})",
       "/cameras/0/orthographic/xmag: must not be 0"},
      {R"({"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": -1, "zfar": 1}})",
       "/cameras/0/orthographic/znear: is -1"}};
  for (const auto& [camera, part] : cases) expect_refused(with_camera(camera), part);
}

// --- KHR_lights_punctual ----------------------------------------------------------------------------------------

Model with_light(const char* light) {
  Model model = with_nodes(R"([{"extensions": {"KHR_lights_punctual": {"light": 0}}}])");
  model.root["extensionsUsed"] = {"KHR_lights_punctual"};
  model.root["extensions"]["KHR_lights_punctual"]["lights"] = {Json::parse(light)};
  return model;
}

TEST(GltfLight, KindsAndDefaults) {
  const Scene sun = read(with_light(R"({"type": "directional"})"));
  EXPECT_EQ(sun.nodes.at(0).light, 0);
  EXPECT_EQ(sun.lights.at(0).kind, LightKind::directional);
  EXPECT_EQ(sun.lights.at(0).color, glm::vec3(1.0f));
  EXPECT_EQ(sun.lights.at(0).intensity, 1.0f);
  EXPECT_EQ(sun.lights.at(0).range, 0.0f);
  const Light spot = read(with_light(R"({"name": "s", "type": "spot", "color": [0.5, 0, 1], "intensity": 20, "range": 3,
    "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}})"))
                         .lights.at(0);
  EXPECT_EQ(spot.kind, LightKind::spot);
  EXPECT_EQ(spot.color, glm::vec3(0.5f, 0, 1));
  EXPECT_EQ(spot.intensity, 20.0f);
  EXPECT_EQ(spot.range, 3.0f);
  EXPECT_EQ(spot.inner_cone, 0.1f);
  EXPECT_EQ(spot.outer_cone, 0.2f);
  const Light plain = read(with_light(R"({"type": "spot", "spot": {}})")).lights.at(0);
  EXPECT_EQ(plain.inner_cone, 0.0f);
  EXPECT_FLOAT_EQ(plain.outer_cone, std::numbers::pi_v<float> / 4.0f);
}

TEST(GltfLight, WrongOnesAreRefused) {
  const std::string at = "/extensions/KHR_lights_punctual/lights/0";
  const std::pair<const char*, std::string> cases[] = {
      {R"({})", at + ": has no property 'type'"},
      {R"({"type": "sphere"})", at + "/type: is 'sphere'"},
      {R"({"type": "spot"})", at + ": has no property 'spot'"},
      {R"({"type": "spot", "spot": {"outerConeAngle": 0}})", at + "/spot/outerConeAngle: is 0"},
      {R"({"type": "spot", "spot": {"outerConeAngle": 2}})", at + "/spot/outerConeAngle: must be at most pi/2"}};
  for (const auto& [light, part] : cases) expect_refused(with_light(light), part);
  Model model = with_light(R"({"type": "point"})");
  model.root["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 1;
  expect_refused(model, "/nodes/0/extensions/KHR_lights_punctual/light: is 1, but there are 1 lights");
}

TEST(GltfLight, OddOnesAreRepaired) {
  const std::string at = "/extensions/KHR_lights_punctual/lights/0";
  const auto repaired = [&](const char* light, const std::string& part) {
    return expect_repaired(with_light(light), at + part).lights.at(0);
  };
  EXPECT_EQ(repaired(R"({"type": "point", "range": 0})", "/range: is 0").range, 0.0f);
  const auto expect_cones = [](const Light& light, float inner, float outer) {
    EXPECT_EQ(light.inner_cone, inner);
    EXPECT_EQ(light.outer_cone, outer);
  };
  expect_cones(
      repaired(R"({"type": "spot", "spot": {"innerConeAngle": 0.3, "outerConeAngle": 0.2}})", "/spot/outerConeAngle"),
      0.2f, 0.2f);
  expect_cones(
      repaired(R"({"type": "spot", "spot": {"innerConeAngle": 0.5, "outerConeAngle": 0.5}})", "/spot/outerConeAngle"),
      0.5f, 0.5f);
  expect_cones(repaired(R"({"type": "spot", "spot": {"innerConeAngle": 0.9}})", "/spot/innerConeAngle"), 0.7853982f,
               0.7853982f);
  expect_cones(repaired(R"({"type": "spot", "spot": {"innerConeAngle": -1}})", "/spot/innerConeAngle"), 0.0f,
               0.7853982f);
}

// JSON numbers are doubles: these angles differ there, and are one float.
TEST(GltfLight, ConesMayDifferByLessThanFloatsDo) {
  const Scene scene = read(with_light(R"({"type": "spot", "spot": {"innerConeAngle": 0.08968102931976317,
                                                                   "outerConeAngle": 0.08968102931976318}})"));
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_EQ(scene.lights.at(0).inner_cone, scene.lights.at(0).outer_cone);
}

}  // namespace
}  // namespace velarium::scene::test
