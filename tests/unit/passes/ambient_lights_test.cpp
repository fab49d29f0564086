// Which ambient lights a view gets, and how shaders see them.

#include "passes/ambient_lights/ambient_lights.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace velarium::ambient_lights {
namespace {

// Looks from here along -z, 90 degrees upright and across.
upload::ViewMatrices view_from(const glm::vec3& eye) {
  scene::CameraInstance camera{.camera = {.vertical_fov = 1.5707964f}};
  camera.world_from_view[3] = glm::vec4(eye, 1.0f);
  return upload::view_matrices(camera, 1.0f);
}

class AmbientLightsInView : public testing::Test {
 protected:
  void add(const glm::mat4& world_from_node, float range = 1.0f) {
    snapshot_.ambient_lights.push_back({{.color = glm::vec3(0.5f), .range = range}, world_from_node});
  }
  [[nodiscard]] std::vector<shading::GpuAmbientLight> seen(const upload::ViewMatrices& view,
                                                           const glm::dvec3& origin = glm::dvec3(0.0)) const {
    upload::Tables tables{.origin = origin};
    tables.snapshot = &snapshot_;
    return lights_in_view(tables, view);
  }

 private:
  scene::SceneSnapshot snapshot_;
};

glm::mat4 at(const glm::vec3& place, const glm::vec3& scale = glm::vec3(1.0f)) {
  return glm::scale(glm::translate(glm::mat4(1.0f), place), scale);
}

TEST_F(AmbientLightsInView, AreThoseWhoseVolumesItSees) {
  add(at({0, 0, -5}));
  add(at({0, 0, 5}));               // behind the eye
  add(at({8, 0, -5}));              // right of the view
  add(at({5.5f, 0, -5}));           // its centre is, but not all of it
  add(at({0, 0, 5}), 6.0f);         // around the eye
  add(at({0, 12, -5}, {1, 9, 1}));  // an ellipsoid that hangs into it
  const auto lights = seen(view_from(glm::vec3(0.0f)));
  ASSERT_EQ(lights.size(), 4u);
  EXPECT_EQ(lights[0].z.w, -5.0f);
  EXPECT_EQ(lights[1].x.w, 5.5f);
  EXPECT_EQ(lights[2].z.w, 5.0f);
  EXPECT_EQ(lights[3].y.w, 12.0f);
}

// Turned by a quarter about y, x goes to -z: the extents are 2 along x, 3 along y, 1 along z.
TEST_F(AmbientLightsInView, AreTheVolumesOfTheirNodes) {
  const glm::mat4 turned = glm::rotate(at({1, 2, -3}), 1.5707964f, glm::vec3(0, 1, 0));
  add(glm::scale(turned, glm::vec3(0.5f, 1.5f, 1.0f)), 2.0f);
  const auto lights = seen(view_from(glm::vec3(0.0f)));
  ASSERT_EQ(lights.size(), 1u);
  const auto attenuation = [&](const glm::vec3& offset) {
    return shading::ambient_attenuation(lights[0], glm::vec3(1, 2, -3) + offset);
  };
  for (const glm::vec3& extent : {glm::vec3(2, 0, 0), glm::vec3(0, 3, 0), glm::vec3(0, 0, 1)}) {
    EXPECT_NEAR(attenuation(0.5f * extent), 0.5625f, 1e-5f);
    EXPECT_NEAR(attenuation(-0.5f * extent), 0.5625f, 1e-5f);
    EXPECT_NEAR(attenuation(extent), 0.0f, 1e-10f);
  }
}

TEST_F(AmbientLightsInView, KeepTheirDigitsFarFromTheOrigin) {
  const glm::vec3 far_away(1048576.0f, 0.0f, 0.0f);
  add(at(far_away + glm::vec3(0.125f, 0, -5)));
  const auto lights = seen(view_from(far_away), glm::dvec3(far_away));
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0].x.w, 0.125f);
}

TEST_F(AmbientLightsInView, AreNoneWhereTheirNodesAreFlat) {
  add(at({0, 0, -5}, {1, 0, 1}));
  add(at({0, 0, -5}, {1, 1e-20f, 1}));
  EXPECT_TRUE(seen(view_from(glm::vec3(0.0f))).empty());
}

}  // namespace
}  // namespace velarium::ambient_lights
