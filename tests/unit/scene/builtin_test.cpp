#include "scene/builtin.hpp"

#include <velarium/error.hpp>

#include "scene/snapshot.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace velarium::scene {
namespace {

// Flat blocks and fine spheres, seen from outside.
const std::vector<std::string> kPlainScenes{"spheres", "furnace", "cornell"};

glm::vec3 corner(const Primitive& p, std::size_t i) {
  return p.vertices.positions[p.indices[i]];
}

TEST(Builtin, NamesAreThoseThatCanBeMade) {
  const std::vector<std::string> names = builtin_names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()),
            (std::set<std::string>{"atrium", "spheres", "furnace", "cornell", "boxes", "knots", "terrain"}));
  for (const std::string& name : names) EXPECT_EQ(builtin_scene(name).source, "builtin:" + name);
  try {
    (void)builtin_scene("teapot");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::input_missing);
    for (const std::string& name : names) EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
  }
}

// What the rest of the program may rely on after reading a file holds for these scenes too.
TEST(Builtin, TablesAreWhole) {
  for (const std::string& name : builtin_names()) {
    const Scene scene = builtin_scene(name);
    for (const Primitive& p : scene.primitives) {
      ASSERT_EQ(p.indices.size() % 3, 0u);
      ASSERT_EQ(p.vertices.normals.size(), p.vertex_count());
      ASSERT_EQ(p.uv[0].size(), p.vertex_count());
      ASSERT_LT(static_cast<std::size_t>(p.material), scene.materials.size());
      ASSERT_LT(*std::ranges::max_element(p.indices), p.vertex_count());
      for (const glm::vec3& n : p.vertices.normals) ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
      for (const glm::vec3& q : p.vertices.positions) {
        ASSERT_EQ(glm::min(q, p.bounds.min), p.bounds.min);
        ASSERT_EQ(glm::max(q, p.bounds.max), p.bounds.max);
      }
    }
  }
}

TEST(Builtin, FrontFacesAgreeWithNormals) {
  for (const std::string& name : kPlainScenes) {
    for (const Primitive& p : builtin_scene(name).primitives) {
      for (std::size_t i = 0; i < p.indices.size(); i += 3) {
        const glm::vec3 area = glm::cross(corner(p, i + 1) - corner(p, i), corner(p, i + 2) - corner(p, i));
        ASSERT_GT(glm::length(area), 0.0f) << name;
        ASSERT_GT(glm::dot(glm::normalize(area), p.vertices.normals[p.indices[i]]), 0.9f) << name;
      }
    }
  }
}

// The area of a fine sphere comes close to 4 pi r^2 from below: for a mesh of 32 x 64 within half a percent.
TEST(Builtin, SpheresAreSpheres) {
  const Scene scene = builtin_scene("furnace");
  const Primitive& p = scene.primitives.front();
  double area = 0;
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    area += 0.5 * glm::length(glm::cross(corner(p, i + 1) - corner(p, i), corner(p, i + 2) - corner(p, i)));
  }
  const double exact = 4 * glm::pi<double>() * 0.45 * 0.45;
  EXPECT_LT(area, exact);
  EXPECT_GT(area, 0.995 * exact);
}

TEST(Builtin, FurnaceIsWhiteAndHasNothingButSpheres) {
  const Scene scene = builtin_scene("furnace");
  EXPECT_TRUE(scene.lights.empty());
  std::set<float> roughnesses, metallics;
  for (const Material& m : scene.materials) {
    EXPECT_EQ(m.base_color, glm::vec4(1));
    EXPECT_EQ(m.specular_color, glm::vec3(1));
    EXPECT_EQ(m.emissive, glm::vec3(0));
    roughnesses.insert(m.perceptual_roughness);
    metallics.insert(m.metallic);
  }
  EXPECT_EQ(*roughnesses.begin(), 0.0f);
  EXPECT_EQ(*roughnesses.rbegin(), 1.0f);
  EXPECT_EQ(metallics, (std::set<float>{0.0f, 0.5f, 1.0f}));
}

TEST(Builtin, CornellWallsFaceInAndTheLampHasTheFluxOfItsArea) {
  const Scene scene = builtin_scene("cornell");
  const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
  const glm::vec3 center(0.5 * (snapshot.bounds.min + snapshot.bounds.max));
  std::size_t walls = 0;
  for (const Instance& instance : snapshot.instances) {
    const Primitive& p = scene.primitives[instance.primitive];
    if (p.vertex_count() != 4) continue;
    ++walls;
    EXPECT_GT(glm::dot(p.vertices.normals[0], center - p.vertices.positions[0]), 0.0f)
        << scene.nodes[instance.node].name;
  }
  EXPECT_EQ(walls, 6u);  // five walls and the light
  ASSERT_EQ(snapshot.lights.size(), 1u);
  const Light& light = snapshot.lights[0].light;
  EXPECT_LT(glm::length(snapshot.lights[0].direction - glm::vec3(0, -1, 0)), 1e-5f);
  const double lamp_flux = glm::pi<double>() * 17 * 1.30 * 1.05;
  EXPECT_NEAR(light.intensity * 2 * glm::pi<double>() / 3, lamp_flux, 1e-3);
}

TEST(Builtin, EveryCameraSeesTheWholeScene) {
  constexpr float kAspect = 1.0f;
  for (const std::string& name : kPlainScenes) {
    const Scene scene = builtin_scene(name);
    const SceneSnapshot snapshot = snapshot_at(scene, 0, "");
    ASSERT_EQ(snapshot.cameras.size(), 1u);
    const glm::dmat4 clip_from_world = glm::dmat4(clip_from_view(snapshot.cameras[0].camera, kAspect)) *
                                       glm::inverse(snapshot.cameras[0].world_from_view);
    glm::vec3 low(1e9f), high(-1e9f);
    for (const Instance& instance : snapshot.instances) {
      for (const glm::vec3& q : scene.primitives[instance.primitive].vertices.positions) {
        const glm::vec4 clip(clip_from_world * instance.world_from_object * glm::dvec4(q, 1));
        ASSERT_GT(clip.w, 0.0f);
        low = glm::min(low, glm::vec3(clip) / clip.w);
        high = glm::max(high, glm::vec3(clip) / clip.w);
      }
    }
    EXPECT_LE(std::max({-low.x, -low.y, high.x, high.y}), 1.01f) << name;
    EXPECT_GE(std::max({-low.x, -low.y, high.x, high.y}), 0.8f) << name;
  }
}

}  // namespace
}  // namespace velarium::scene
