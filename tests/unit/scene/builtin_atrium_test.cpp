#include "scene/builtin.hpp"
#include "scene/snapshot.hpp"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace velarium::scene {
namespace {

class Atrium : public ::testing::Test {
 protected:
  static const Scene& scene() {
    static const Scene made = builtin_scene("atrium");
    return made;
  }
  static const Primitive& part(const std::string& name) {
    const auto mesh = std::ranges::find_if(scene().meshes, [&](const Mesh& m) { return m.name == name; });
    EXPECT_NE(mesh, scene().meshes.end()) << name;
    return scene().primitives[mesh->primitives.front()];
  }
  // How much of the surroundings' light reaches a part, on average over its vertices.
  static float daylight(const std::string& name) {
    const Primitive& p = part(name);
    float sum = 0.0f;
    for (const glm::vec2& uv : p.uv[1]) sum += uv.x;
    return sum / static_cast<float>(p.vertex_count());
  }
};

TEST_F(Atrium, IsAsLargeAsPromised) {
  const SceneSnapshot snapshot = snapshot_at(scene(), 0, "");
  std::size_t triangles = 0;
  for (const Instance& instance : snapshot.instances)
    triangles += scene().primitives[instance.primitive].indices.size() / 3;
  EXPECT_GE(triangles, 150'000u);
  EXPECT_LE(triangles, 400'000u);
  EXPECT_LE(scene().materials.size(), 26u);
  // The court is 16 m by 12 m between its columns; walks 3 m wide and roofs lie around it.
  const glm::vec3 size = snapshot.bounds.max - snapshot.bounds.min;
  EXPECT_NEAR(size.x, 12 + 2 * 3.3f, 0.3f);
  EXPECT_NEAR(size.z, 16 + 2 * 3.3f, 0.3f);
}

TEST_F(Atrium, HasItsTorchesItsCamerasAndItsSky) {
  const Scene without_sun = builtin_scene("atrium?sun=off");
  ASSERT_EQ(without_sun.lights.size(), 24u);
  for (const Light& light : without_sun.lights) {
    EXPECT_EQ(light.kind, LightKind::point);
    EXPECT_EQ(light.range, 8.0f);
    EXPECT_EQ(light.radius, 0.0f);
    EXPECT_GT(light.color.r, light.color.b);
  }
  const SceneSnapshot snapshot = snapshot_at(scene(), 0, "");
  ASSERT_EQ(snapshot.cameras.size(), 3u);
  EXPECT_EQ(snapshot.cameras[0].camera.name, "entrance");
  EXPECT_EQ(snapshot.cameras[1].camera.name, "pool");
  EXPECT_EQ(snapshot.cameras[2].camera.name, "walk");
  EXPECT_EQ(scene().environment, "sky");
}

TEST_F(Atrium, HasASunLargeFlamesAndALantern) {
  const auto count = [&](auto holds) { return std::ranges::count_if(scene().lights, holds); };
  EXPECT_EQ(count([](const Light& l) { return l.kind == LightKind::point && l.radius > 0.0f; }), 24);
  EXPECT_EQ(count([](const Light& l) { return l.kind == LightKind::directional && l.angular_radius > 0.0f; }), 1);
  EXPECT_EQ(count([](const Light& l) { return l.kind == LightKind::spot && l.projector.present(); }), 1);
  EXPECT_EQ(scene().lights.size(), 26u);
}

TEST_F(Atrium, NormalMapsHaveTangentsAndOcclusionItsOwnTextureCoordinates) {
  for (const Primitive& p : scene().primitives) {
    const Material& m = scene().materials[static_cast<std::size_t>(p.material)];
    if (m.normal_texture.present()) { EXPECT_EQ(p.vertices.tangents.size(), p.vertex_count()) << m.name; }
    ASSERT_EQ(p.uv[1].size(), p.vertex_count()) << m.name;
    for (const glm::vec2& uv : p.uv[1]) ASSERT_TRUE(uv.x >= 0.0f && uv.x <= 1.0f) << m.name;
  }
}

// Normals follow the smooth surface and triangles its chords: where a volute rolls up tighter than it is thick, inside
// it, they part; nowhere else often.
TEST_F(Atrium, FrontFacesAgreeWithNormals) {
  for (const Mesh& mesh : scene().meshes) {
    const Primitive& p = scene().primitives[mesh.primitives.front()];
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < p.indices.size(); i += 3) {
      const auto at = [&](std::size_t k) { return p.vertices.positions[p.indices[i + k]]; };
      const glm::vec3 area = glm::cross(at(1) - at(0), at(2) - at(0));
      ASSERT_GT(glm::length(area), 0.0f) << mesh.name;
      for (std::size_t k = 0; k < 3; ++k) wrong += glm::dot(area, p.vertices.normals[p.indices[i + k]]) <= 0.0f;
    }
    EXPECT_LE(static_cast<double>(wrong), 0.05 * static_cast<double>(p.indices.size())) << mesh.name;
  }
}

TEST_F(Atrium, DaylightFallsIntoTheCourtAndHardlyIntoTheWalks) {
  EXPECT_GT(daylight("court floor"), 0.5f);
  EXPECT_LT(daylight("walk floor"), 0.65f * daylight("court floor"));
  EXPECT_LT(daylight("coffers"), 0.5f);
  EXPECT_GT(daylight("long roof"), 0.8f);
}

TEST_F(Atrium, IsTheSameEveryTime) {
  const Scene again = builtin_scene("atrium");
  ASSERT_EQ(again.images.size(), scene().images.size());
  for (std::size_t i = 0; i < again.images.size(); ++i) EXPECT_EQ(again.images[i].rgba, scene().images[i].rgba);
  for (std::size_t i = 0; i < again.primitives.size(); ++i) {
    EXPECT_EQ(again.primitives[i].vertices.positions, scene().primitives[i].vertices.positions);
    EXPECT_EQ(again.primitives[i].uv[1], scene().primitives[i].uv[1]);
  }
}

// A texture whose last column did not meet its first would show a seam every few metres on every wall.
TEST_F(Atrium, PaintedTexturesTile) {
  for (const Material& m : scene().materials) {
    if (!m.base_color_texture.present() || m.name == "fresco") continue;
    const Image& image = scene().images[static_cast<std::size_t>(
        scene().textures[static_cast<std::size_t>(m.base_color_texture.texture)].image)];
    const auto jump = [&](std::uint32_t a, std::uint32_t b) {  // mean difference of two columns
      double sum = 0;
      for (std::uint32_t y = 0; y < image.height; ++y) {
        const std::size_t row = 4 * static_cast<std::size_t>(y) * image.width;
        sum += std::abs(image.rgba[row + 4 * a] - image.rgba[row + 4 * b]);
      }
      return sum / image.height;
    };
    double largest_inside = 0;
    for (std::uint32_t x = 1; x < image.width; ++x) largest_inside = std::max(largest_inside, jump(x - 1, x));
    EXPECT_LE(jump(image.width - 1, 0), 1.2 * largest_inside + 2.0) << m.name;
  }
}

}  // namespace
}  // namespace velarium::scene
