#include "scene/builtin.hpp"

#include <velarium/error.hpp>

#include "scene/snapshot.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace velarium::scene {
namespace {

std::uint64_t triangles_of(const Scene& scene, const std::string& mesh_name) {
  std::uint64_t count = 0;
  for (const Instance& instance : snapshot_at(scene, 0, "").instances) {
    const auto mesh = static_cast<std::size_t>(scene.nodes[instance.node].mesh);
    if (scene.meshes[mesh].name == mesh_name) count += scene.primitives[instance.primitive].indices.size() / 3;
  }
  return count;
}

// Luminous flux in lumens: the intensity over all directions, by the closed form of what KHR_lights_punctual
// recommends, a ramp that is linear in the cosine and then squared.
double flux(const Light& light) {
  if (light.kind == LightKind::point) return 4.0 * glm::pi<double>() * light.intensity;
  double sum = 0;
  constexpr int kSteps = 100'000;
  const double inner = std::cos(light.inner_cone), outer = std::cos(light.outer_cone);
  for (int i = 0; i < kSteps; ++i) {
    const double cosine = -1.0 + 2.0 * (i + 0.5) / kSteps;
    const double ramp = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
    sum += ramp * ramp * 2.0 / kSteps;
  }
  return 2.0 * glm::pi<double>() * light.intensity * sum;
}

double trefoil_length() {
  const auto at = [](double a) {
    const double r = 0.72 * (1.0 + 0.5 * std::cos(3.0 * a));
    return glm::dvec3(r * std::cos(2.0 * a), 0.42 * std::sin(3.0 * a), r * std::sin(2.0 * a));
  };
  double length = 0;
  constexpr int kSteps = 10'000;
  const double step = glm::two_pi<double>() / kSteps;
  for (int i = 0; i < kSteps; ++i) length += glm::length(at((i + 1) * step) - at(i * step));
  return length;
}

TEST(BuiltinParameters, ErrorsListTheKeysAndTheirRanges) {
  for (const char* wrong : {"terrain?", "terrain?triangles", "terrain?triangles=", "terrain?triangles=9999",
                            "terrain?triangles=10000001", "terrain?triangles=2e4", "terrain?Triangles=20000",
                            "terrain?triangles=20000&", "terrain?triangles=20000&size=3", "terrain?triangles=-1"}) {
    try {
      (void)builtin_parameters(wrong);
      ADD_FAILURE() << wrong;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::usage) << wrong;
      EXPECT_NE(std::string(error.what()).find("triangles=10000..10000000"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW((void)builtin_scene("cornell?lights=2"), Error);
}

TEST(BuiltinParameters, TellDefaultsAndValues) {
  EXPECT_TRUE(builtin_parameters("cornell").empty());
  ASSERT_EQ(builtin_parameters("atrium").size(), 2u);
  EXPECT_EQ(builtin_parameters("atrium")[0].value, 24u);
  EXPECT_EQ(builtin_parameters("atrium?lights=7")[0].value, 7u);
  EXPECT_EQ(builtin_parameters("atrium?lights=7&lights=8")[0].value, 8u);
  EXPECT_EQ(builtin_scene("knots?instances=3").source, "builtin:knots?instances=3");
}

TEST(BuiltinParameters, NamesStandForValues) {
  const auto parameters = builtin_parameters("boxes?light=spot&radius=250");
  ASSERT_EQ(parameters.size(), 3u);
  EXPECT_EQ(parameters[0].key, "light");
  EXPECT_EQ(parameters[0].names.at(parameters[0].value), "spot");
  EXPECT_EQ(parameters[1].value, 250u);
  EXPECT_EQ(parameters[2].names.at(parameters[2].value), "on");
  for (const char* wrong : {"boxes?light=2", "boxes?light=lamp", "boxes?light=", "boxes?sheet=1", "boxes?radius=on"}) {
    try {
      (void)builtin_parameters(wrong);
      ADD_FAILURE() << wrong;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::usage) << wrong;
      for (const char* text : {"light=sun|point|spot [sun]", "radius=0..1000 [0]", "sheet=off|on [on]"})
        EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  }
}

TEST(BuiltinParameters, BoxesHaveTheLightThatIsAskedFor) {
  const std::pair<const char*, LightKind> kinds[] = {
      {"sun", LightKind::directional}, {"point", LightKind::point}, {"spot", LightKind::spot}};
  for (const auto& [name, kind] : kinds) {
    const Scene scene = builtin_scene("boxes?radius=250&light=" + std::string(name));
    ASSERT_EQ(scene.lights.size(), 1u) << name;
    EXPECT_EQ(scene.lights[0].kind, kind) << name;
    const bool sun = kind == LightKind::directional;
    EXPECT_EQ(scene.lights[0].radius, sun ? 0.0f : 0.25f) << name;
    EXPECT_EQ(scene.lights[0].angular_radius, sun ? 0.25f : 0.0f) << name;
    EXPECT_EQ(scene.environment, "none");
    EXPECT_LT(snapshot_at(scene, 0, "").lights[0].direction.y, -0.1f) << name;
  }
  EXPECT_EQ(builtin_scene("boxes").lights[0].radius, 0.0f);
  EXPECT_EQ(triangles_of(builtin_scene("boxes"), "sheet"), 2u);
  EXPECT_EQ(triangles_of(builtin_scene("boxes?sheet=off"), "sheet"), 0u);
}

TEST(BuiltinParameters, LampsHaveThePowerOfTheTorches) {
  double torches = 0;
  for (const Light& light : builtin_scene("atrium?sun=off").lights) torches += flux(light);
  for (const unsigned count : {16u, 1024u}) {
    const Scene scene = builtin_scene("atrium?sun=off&lights=" + std::to_string(count));
    ASSERT_EQ(scene.lights.size(), count);
    double lights = 0;
    for (const Light& light : scene.lights) lights += flux(light);
    EXPECT_NEAR(lights, torches, 1e-3 * torches);
    for (const LightInstance& light : snapshot_at(scene, 0, "").lights) {
      EXPECT_LT(std::abs(light.position.x), 9.0f);
      EXPECT_LT(std::abs(light.position.z), 11.0f);
      EXPECT_LT(light.position.y, 4.25f);
    }
  }
  EXPECT_TRUE(builtin_scene("atrium?sun=off&lights=0").lights.empty());
}

TEST(BuiltinParameters, KnotsAreAsManyAsAskedAndCoverOneDisc) {
  for (const unsigned count : {1u, 2u, 256u, 4096u}) {
    const Scene scene = builtin_scene("knots?instances=" + std::to_string(count));
    EXPECT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(triangles_of(scene, "knot"), 1152u * count);
    for (const Instance& instance : snapshot_at(scene, 0, "").instances) {
      EXPECT_GE(instance.bounds.min.y, -1e-4f);
      EXPECT_LT(glm::length(glm::vec2(instance.world_from_object[3].x, instance.world_from_object[3].z)), 3.01f);
    }
  }
}

// The volume inside a closed surface is positive where its front faces look out (divergence theorem), and that of a bar
// is its section times its length (Pappus): a hexagon in a circle of 0.2 m, along the trefoil.
TEST(BuiltinParameters, KnotsAreClosedAndLookOut) {
  const Scene scene = builtin_scene("knots?instances=1");
  const Primitive& p = scene.primitives[1];
  double volume = 0;
  glm::dvec3 area(0);
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(p.vertices.positions[p.indices[i + k]]); };
    volume += glm::dot(at(0), glm::cross(at(1), at(2))) / 6.0;
    area += glm::cross(at(1) - at(0), at(2) - at(0));
  }
  const double section = 1.5 * std::sqrt(3.0) * 0.2 * 0.2;
  EXPECT_NEAR(volume, section * trefoil_length(), 0.03 * volume);
  EXPECT_LT(glm::length(area), 1e-4);
}

TEST(BuiltinParameters, TerrainHasItsTrianglesWithinAHundredth) {
  for (const double count : {10'000.0, 123'456.0, 1'000'000.0}) {
    const Scene scene = builtin_scene("terrain?triangles=" + std::to_string(static_cast<int>(count)));
    EXPECT_NEAR(static_cast<double>(triangles_of(scene, "land")), count, 0.01 * count);
  }
}

TEST(BuiltinParameters, TerrainIsTheSameLandWithMoreDetail) {
  const auto peak = [](const char* name) { return snapshot_at(builtin_scene(name), 0, "").bounds.max.y; };
  const float coarse = peak("terrain?triangles=10000"), fine = peak("terrain?triangles=400000");
  EXPECT_GT(coarse, 200.0f);
  EXPECT_NEAR(coarse, fine, 0.25f * fine);
  EXPECT_EQ(fine, peak("terrain?triangles=400000"));
}

}  // namespace
}  // namespace velarium::scene
