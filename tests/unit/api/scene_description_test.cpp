// What Scene::make() refuses, with what words, and what it makes of the rest.
#include <velarium/scene.hpp>

#include "scene/snapshot.hpp"

#include <velarium/error.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace velarium {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// One of everything, and nothing wrong.
SceneDescription complete() {
  SceneDescription d{.name = "test"};
  d.images = {{.name = "pixel", .width = 1, .height = 1, .rgba = {255, 128, 0, 255}}};
  d.materials = {{.name = "paint", .base_color_texture = {.image = 0}}};
  d.meshes = {{.name = "triangle",
               .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
               .normals = {{0, 0, 2}, {0, 0, 1}, {0, 0, 1}},
               .uv = {{0, 1}, {1, 1}, {0, 0}},
               .colors = {{1, 1, 1, 1}, {1, 1, 1, 1}, {0, 1, 1, 0.5f}},
               .indices = {0, 1, 2},
               .material = 0}};
  d.nodes = {{.name = "place", .translation = {0, 0, -1}}, {.name = "figure", .parent = 0, .mesh = 0}};
  d.lights = {{.name = "sun", .kind = LightKind::directional, .intensity = 3, .angular_radius_deg = 0.25f},
              {.name = "bulb", .parent = 0, .position = {1, 2, 3}, .radius_m = 0.1f},
              {.name = "lantern", .kind = LightKind::spot, .projected_image = 0}};
  d.cameras = {{.name = "eye", .view = {.eye = {0, 0, 5}, .target = {0, 0, 0}}},
               {.name = "plan",
                .view = {.eye = {0, 9, 0}, .target = {0, 0, 0}, .up = {0, 0, -1}},
                .orthographic_height_m = 4,
                .far_m = 20}};
  return d;
}

struct Refusal {
  const char* says;  // after "scene description: "
  std::function<void(SceneDescription&)> damage;
};

void expect_refused(const std::vector<Refusal>& refusals) {
  for (const Refusal& refusal : refusals) {
    SceneDescription description = complete();
    refusal.damage(description);
    try {
      (void)Scene::make(description);
      ADD_FAILURE() << "nothing was thrown; expected " << refusal.says;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::usage);
      EXPECT_EQ(std::string(error.what()), std::string("scene description: ") + refusal.says);
    }
  }
}

TEST(SceneDescription, RefusesImages) {
  expect_refused({
      {"images[0].width is 0, must be from 1 to 16384", [](auto& d) { d.images[0].width = 0; }},
      {"images[0].height is 16385, must be from 1 to 16384", [](auto& d) { d.images[0].height = 16385; }},
      {"images[0].rgba has 3 values, but 1 x 1 pixels have 4", [](auto& d) { d.images[0].rgba.pop_back(); }},
  });
}

TEST(SceneDescription, RefusesMaterials) {
  const auto material = [](auto change) { return [change](SceneDescription& d) { change(d.materials[0]); }; };
  expect_refused({
      {"materials[0].base_color is 1.5, must be from 0 to 1", material([](auto& m) { m.base_color[1] = 1.5f; })},
      {"materials[0].metallic is nan, must be from 0 to 1", material([](auto& m) { m.metallic = kNan; })},
      {"materials[0].perceptual_roughness is -1, must be from 0 to 1",
       material([](auto& m) { m.perceptual_roughness = -1; })},
      {"materials[0].normal_scale is inf, must be finite", material([](auto& m) { m.normal_scale = kInfinity; })},
      {"materials[0].occlusion_strength is 2, must be from 0 to 1",
       material([](auto& m) { m.occlusion_strength = 2; })},
      {"materials[0].emissive is -1, must not be negative", material([](auto& m) { m.emissive[2] = -1; })},
      {"materials[0].emissive is inf, must be finite", material([](auto& m) { m.emissive[2] = kInfinity; })},
      {"materials[0].ior is 0.5, must be 0 or at least 1", material([](auto& m) { m.ior = 0.5f; })},
      {"materials[0].specular is 2, must be from 0 to 1", material([](auto& m) { m.specular = 2; })},
      {"materials[0].specular_color is -1, must not be negative", material([](auto& m) { m.specular_color[0] = -1; })},
      {"materials[0].alpha_cutoff is -1, must not be negative", material([](auto& m) { m.alpha_cutoff = -1; })},
      {"materials[0].normal_texture.image is 1, but there is 1 in images",
       material([](auto& m) { m.normal_texture.image = 1; })},
      {"materials[0].emissive_texture.image is 7, but there is 1 in images",
       material([](auto& m) { m.emissive_texture.image = 7; })},
  });
}

TEST(SceneDescription, RefusesMeshes) {
  const auto mesh = [](auto change) { return [change](SceneDescription& d) { change(d.meshes[0]); }; };
  expect_refused({
      {"meshes[0].positions has 0 elements, must have from 3 to 4294967295",
       mesh([](auto& m) { m.positions.clear(); })},
      {"meshes[0].positions[1] is nan, must be finite", mesh([](auto& m) { m.positions[1][2] = kNan; })},
      {"meshes[0].normals has 2 elements, but there are 3 positions", mesh([](auto& m) { m.normals.pop_back(); })},
      {"meshes[0].normals[2] is inf, must be finite", mesh([](auto& m) { m.normals[2][0] = kInfinity; })},
      {"meshes[0].normals[1] has no length, or one that is no number", mesh([](auto& m) { m.normals[1] = {}; })},
      {"meshes[0].normals[1] has no length, or one that is no number", mesh([](auto& m) { m.normals[1][0] = 1e30f; })},
      {"meshes[0].uv has 1 elements, but there are 3 positions", mesh([](auto& m) { m.uv.resize(1); })},
      {"meshes[0].uv[0] is nan, must be finite", mesh([](auto& m) { m.uv[0][1] = kNan; })},
      {"meshes[0].uv is empty, but the mesh's material has textures", mesh([](auto& m) { m.uv.clear(); })},
      {"meshes[0].colors has 4 elements, but there are 3 positions", mesh([](auto& m) { m.colors.resize(4); })},
      {"meshes[0].colors[2] is 1.25, must be from 0 to 1", mesh([](auto& m) { m.colors[2][3] = 1.25f; })},
      {"meshes[0].colors[0] is nan, must be from 0 to 1", mesh([](auto& m) { m.colors[0][3] = kNan; })},
      {"meshes[0].indices[2] is 3, but there are 3 positions", mesh([](auto& m) { m.indices[2] = 3; })},
      {"meshes[0].indices has 2 elements, but triangles need a multiple of 3 below 2^32",
       mesh([](auto& m) { m.indices.pop_back(); })},
      {"meshes[0].positions has 4 elements, but triangles need a multiple of 3 below 2^32", mesh([](auto& m) {
         m = {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
       })},
      {"meshes[0].material is 1, but there is 1 in materials", mesh([](auto& m) { m.material = 1; })},
  });
}

TEST(SceneDescription, RefusesNodes) {
  const auto node = [](auto change) { return [change](SceneDescription& d) { change(d.nodes[1]); }; };
  expect_refused({
      {"nodes[1].parent is 1, must be an earlier node", node([](auto& n) { n.parent = 1; })},
      {"nodes[1].mesh is 1, but there is 1 in meshes", node([](auto& n) { n.mesh = 1; })},
      {"nodes[1].translation is inf, must be finite", node([](auto& n) { n.translation[0] = kInfinity; })},
      {"nodes[1].rotation is nan, must be finite", node([](auto& n) { n.rotation[3] = kNan; })},
      {"nodes[1].rotation is a quaternion of length 2, must be 1", node([](auto& n) { n.rotation[3] = 2; })},
      {"nodes[1].scale is nan, must be finite", node([](auto& n) { n.scale[1] = kNan; })},
      {"nodes[1].matrix is nan, must be finite", node([](auto& n) { n.matrix = {{kNan}}; })},
      {"nodes[1].matrix has 0 as element 15, must be 1: the last row is 0 0 0 1",
       node([](auto& n) { n.matrix = {{1}}; })},
      {"nodes[1].matrix stands beside translation, rotation or scale; give one of the two", node([](auto& n) {
         n.scale = {2, 2, 2};
         n.matrix = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
       })},
  });
}

TEST(SceneDescription, RefusesLights) {
  const auto light = [](std::size_t which, auto change) {
    return [which, change](SceneDescription& d) { change(d.lights[which]); };
  };
  expect_refused({
      {"lights[1].parent is 2, but there are 2 in nodes", light(1, [](auto& l) { l.parent = 2; })},
      {"lights[1].position is nan, must be finite", light(1, [](auto& l) { l.position[0] = kNan; })},
      {"lights[0].direction has no length, or one that is no number", light(0, [](auto& l) { l.direction = {}; })},
      {"lights[0].direction is inf, must be finite", light(0, [](auto& l) { l.direction[0] = kInfinity; })},
      {"lights[2].up is nan, must be finite", light(2, [](auto& l) { l.up[0] = kNan; })},
      {"lights[1].color is -1, must not be negative", light(1, [](auto& l) { l.color[0] = -1; })},
      {"lights[1].intensity is -1, must not be negative", light(1, [](auto& l) { l.intensity = -1; })},
      {"lights[1].range_m is -1, must not be negative", light(1, [](auto& l) { l.range_m = -1; })},
      {"lights[1].radius_m is -1, must not be negative", light(1, [](auto& l) { l.radius_m = -1; })},
      {"lights[1].angular_radius_deg belongs to a light, which has a radius_m",
       light(1, [](auto& l) { l.angular_radius_deg = 1; })},
      {"lights[1].falloff is that of a bulb, which needs a radius_m", light(1,
                                                                            [](auto& l) {
                                                                              l.radius_m = 0;
                                                                              l.falloff = LightFalloff::bulb;
                                                                            })},
      {"lights[0].angular_radius_deg is 90, must be less than 90",
       light(0, [](auto& l) { l.angular_radius_deg = 90; })},
      {"lights[0].radius_m belongs to a directional light, which has an angular_radius_deg",
       light(0, [](auto& l) { l.radius_m = 1; })},
      {"lights[0].falloff belongs to a directional light, which does not fall off",
       light(0, [](auto& l) { l.falloff = LightFalloff::bulb; })},
      {"lights[2].outer_cone_deg is 91, must be more than 0 and at most 90",
       light(2, [](auto& l) { l.outer_cone_deg = 91; })},
      {"lights[2].inner_cone_deg is 45, must be less than outer_cone_deg",
       light(2, [](auto& l) { l.inner_cone_deg = 45; })},
      {"lights[2].inner_cone_deg is -1, must not be negative", light(2, [](auto& l) { l.inner_cone_deg = -1; })},
      {"lights[2].projected_image is 1, but there is 1 in images", light(2, [](auto& l) { l.projected_image = 1; })},
      {"lights[1].projected_image belongs to a light that is no spot",
       light(1, [](auto& l) { l.projected_image = 0; })},
      {"lights[2].projected_fov_deg is -1, must not be negative", light(2, [](auto& l) { l.projected_fov_deg = -1; })},
      {"lights[2].projected_fov_deg is 180, must be more than 0 and less than 180",
       light(2, [](auto& l) { l.outer_cone_deg = 90; })},
      {"lights[2].projected_soft_edge is 2, must be from 0 to 1", light(2, [](auto& l) { l.projected_soft_edge = 2; })},
  });
}

TEST(SceneDescription, RefusesCameras) {
  const auto camera = [](std::size_t which, auto change) {
    return [which, change](SceneDescription& d) { change(d.cameras[which]); };
  };
  expect_refused({
      {"cameras[0].parent is 9, but there are 2 in nodes", camera(0, [](auto& c) { c.parent = 9; })},
      {"cameras[0].view.eye is nan, must be finite", camera(0, [](auto& c) { c.view.eye[0] = kNan; })},
      {"cameras[0].view.target is inf, must be finite", camera(0, [](auto& c) { c.view.target[0] = kInfinity; })},
      {"cameras[0].view.up is nan, must be finite", camera(0, [](auto& c) { c.view.up[1] = kNan; })},
      {"cameras[0].view.vertical_fov_deg is 180, must be more than 0 and less than 180",
       camera(0, [](auto& c) { c.view.vertical_fov_deg = 180; })},
      {"cameras[0].view is no view: look-at camera: eye and target coincide; move one of them",
       camera(0, [](auto& c) { c.view.eye = c.view.target; })},
      {"cameras[0].aspect is -1, must not be negative", camera(0, [](auto& c) { c.aspect = -1; })},
      {"cameras[0].near_m is -1, must not be negative", camera(0, [](auto& c) { c.near_m = -1; })},
      {"cameras[1].orthographic_height_m is -1, must not be negative",
       camera(1, [](auto& c) { c.orthographic_height_m = -1; })},
      {"cameras[1].far_m is 0, must be more than near_m", camera(1, [](auto& c) { c.far_m = 0; })},
      {"cameras[1].far_m is inf, must be finite", camera(1, [](auto& c) { c.far_m = kInfinity; })},
  });
}

// As velarium/scene_description.hpp and docs/library.md show it.
TEST(SceneDescription, CanBeWrittenInOneGo) {
  SceneDescription description{
      .materials = {{.base_color = {0.8f, 0.2f, 0.1f, 1}}},
      .meshes = {{.positions = {{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .indices = {0, 1, 2}, .material = 0}},
      .lights = {{.kind = LightKind::point, .position = {0, 1, 2}, .intensity = 10}}};
  const SceneInfo info = Scene::make(description).info();
  EXPECT_EQ(info.triangles, 1u);
  EXPECT_EQ(info.lights.at(0).intensity, 10.0f);
}

TEST(SceneDescription, TellsWhatItHolds) {
  const SceneInfo info = Scene::make(complete()).info();
  EXPECT_EQ(info.source, "made in code: test");
  EXPECT_EQ(info.triangles, 1u);
  EXPECT_EQ(info.nodes, 7u);
  EXPECT_EQ(info.images, 1u);
  EXPECT_EQ(info.textures, 1u);
  EXPECT_EQ(info.bounds_min, (std::array<float, 3>{0, 0, -1}));
  EXPECT_EQ(info.bounds_max, (std::array<float, 3>{1, 1, -1}));
  ASSERT_EQ(info.lights.size(), 3u);
  EXPECT_EQ(info.lights[0].kind, "directional");
  EXPECT_EQ(info.lights[1].name, "bulb");
  ASSERT_EQ(info.cameras.size(), 2u);
  EXPECT_EQ(info.cameras[1].kind, "orthographic");
  EXPECT_EQ(Scene::make({}).info().source, "made in code");
}

TEST(SceneDescription, PlacesLightsAndCamerasAsTheirParentsStand) {
  SceneDescription description = complete();
  description.lights[1].direction = {0, 0, -3};
  description.cameras[0].parent = 0;
  const Scene scene = Scene::make(description);
  const scene::SceneSnapshot snapshot = scene::snapshot_at(scene.tables(), 0.0f, "");
  EXPECT_EQ(snapshot.lights[1].position, glm::dvec3(1, 2, 2));
  EXPECT_LT(glm::length(snapshot.lights[0].direction - glm::vec3(0, -1, 0)), 1e-6f);
  EXPECT_LT(glm::length(snapshot.lights[1].direction - glm::vec3(0, 0, -1)), 1e-6f);
  EXPECT_EQ(glm::vec3(snapshot.cameras[0].world_from_view[3]), glm::vec3(0, 0, 4));
}

TEST(SceneDescription, CamerasSeeAsLookAtDoes) {
  const Scene scene = Scene::make(complete());
  const scene::SceneSnapshot snapshot = scene::snapshot_at(scene.tables(), 0.0f, "");
  const auto wanted = scene::look_at_camera({0, 9, 0}, {0, 0, 0}, {0, 0, -1}, 1.0f);
  EXPECT_EQ(snapshot.cameras[1].world_from_view, wanted.world_from_view);
  EXPECT_EQ(snapshot.cameras[1].camera.half_size, glm::vec2(2, 2));
  EXPECT_EQ(snapshot.cameras[1].camera.z_far, 20.0f);
  EXPECT_FLOAT_EQ(snapshot.cameras[0].camera.vertical_fov, 0.7853982f);
}

TEST(SceneDescription, MakesUpForWhatIsLeftOut) {
  const Scene scene = Scene::make({.meshes = {{.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}}}});
  const scene::SceneSnapshot snapshot = scene::snapshot_at(scene.tables(), 0.0f, "");
  ASSERT_EQ(snapshot.instances.size(), 1u);  // no node: the mesh stands once
  const scene::Primitive& primitive = scene.tables().primitives.front();
  EXPECT_EQ(primitive.vertices.normals, std::vector<glm::vec3>(3, {0, 1, 0}));
  EXPECT_EQ(primitive.indices, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(scene.tables().materials.at(static_cast<std::size_t>(primitive.material)).metallic, 0.0f);
}

TEST(SceneDescription, NormalsComeOutOfUnitLength) {
  const Scene scene = Scene::make(complete());
  EXPECT_EQ(scene.tables().primitives.front().vertices.normals, std::vector<glm::vec3>(3, {0, 0, 1}));
}

TEST(SceneDescription, MatricesAndColorsArriveAsTheyAre) {
  SceneDescription description = complete();
  description.nodes[1].matrix = {{2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1}};  // the translation stands last
  const Scene scene = Scene::make(description);
  const scene::SceneSnapshot snapshot = scene::snapshot_at(scene.tables(), 0.0f, "");
  EXPECT_EQ(snapshot.bounds.min, glm::dvec3(5, 6, 6));
  EXPECT_EQ(snapshot.bounds.max, glm::dvec3(7, 9, 6));
  EXPECT_EQ(scene.tables().primitives.front().colors[2], glm::vec4(0, 1, 1, 0.5f));
}

TEST(SceneDescription, MaterialsArriveAsTheyAre) {
  SceneDescription description = complete();
  description.materials[0] = {.name = "leaf",
                              .base_color = {0.1f, 0.2f, 0.3f, 0.4f},
                              .metallic = 0.5f,
                              .perceptual_roughness = 0.6f,
                              .normal_texture = {.image = 0, .filter = TextureFilter::nearest},
                              .normal_scale = -2,
                              .occlusion_strength = 0.7f,
                              .emissive = {10, 20, 30},
                              .ior = 0,
                              .specular = 0.8f,
                              .specular_color = {0, 1, 2},
                              .alpha_mode = AlphaMode::mask,
                              .alpha_cutoff = 0.25f,
                              .double_sided = true,
                              .unlit = true};
  const Scene scene = Scene::make(description);
  const scene::Material& m = scene.tables().materials.at(0);
  EXPECT_EQ(m.name, "leaf");
  EXPECT_EQ(m.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(m.metallic, 0.5f);
  EXPECT_EQ(m.perceptual_roughness, 0.6f);
  EXPECT_EQ(m.normal_scale, -2.0f);
  EXPECT_EQ(m.occlusion_strength, 0.7f);
  EXPECT_EQ(m.emissive, glm::vec3(10, 20, 30));
  EXPECT_EQ(m.ior, 0.0f);
  EXPECT_EQ(m.specular, 0.8f);
  EXPECT_EQ(m.specular_color, glm::vec3(0, 1, 2));
  EXPECT_EQ(m.alpha_mode, scene::AlphaMode::mask);
  EXPECT_EQ(m.alpha_cutoff, 0.25f);
  EXPECT_TRUE(m.double_sided && m.unlit);
  EXPECT_TRUE(m.normal_texture.present() && !m.base_color_texture.present());
  EXPECT_EQ(scene.tables().textures.at(0).sampler.mag, scene::Filter::nearest);
}

TEST(SceneDescription, EqualUsesOfAnImageAreOneTexture) {
  SceneDescription description = complete();
  description.materials[0].emissive_texture = {.image = 0};
  description.materials[0].occlusion_texture = {.image = 0, .wrap_u = TextureWrap::clamp_to_edge};
  const Scene scene = Scene::make(description);
  ASSERT_EQ(scene.tables().textures.size(), 2u);
  EXPECT_EQ(scene.tables().materials[0].emissive_texture.texture,
            scene.tables().materials[0].base_color_texture.texture);
  EXPECT_EQ(scene.tables().textures[1].sampler.wrap_u, scene::Wrap::clamp_to_edge);
}

}  // namespace
}  // namespace velarium
