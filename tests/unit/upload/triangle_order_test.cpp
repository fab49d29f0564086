#include "upload/triangle_order.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace velarium::upload {
namespace {

using Indices = std::vector<std::uint32_t>;

// Triangles of a tenth around (x, 0, z), three vertices each.
std::vector<glm::vec3> triangles_at(std::initializer_list<glm::vec2> places) {
  std::vector<glm::vec3> positions;
  for (const auto& place : places)
    for (const glm::vec2 corner : {glm::vec2(-0.1f, -0.1f), glm::vec2(0.1f, -0.1f), glm::vec2(0.0f, 0.2f)})
      positions.emplace_back(place.x + corner.x, corner.y, place.y);
  return positions;
}

Indices in_order(std::initializer_list<std::uint32_t> triangles) {
  Indices indices;
  for (const std::uint32_t t : triangles) indices.insert(indices.end(), {3 * t, 3 * t + 1, 3 * t + 2});
  return indices;
}

TEST(TriangleOrder, FarOnesComeFirst) {
  const auto positions = triangles_at({{0, -1}, {0, -3}, {0, -2}});
  EXPECT_EQ(far_to_near(in_order({0, 1, 2}), positions, glm::mat4(1.0f), {}), in_order({1, 2, 0}));
}

TEST(TriangleOrder, EquallyFarOnesStayAsTheyStand) {
  const auto positions = triangles_at({{0, -1}, {0, -1}, {0, -1}});
  EXPECT_EQ(far_to_near(in_order({2, 0, 1}), positions, glm::mat4(1.0f), {}), in_order({2, 0, 1}));
}

TEST(TriangleOrder, AnObjectIsSeenWhereItStands) {
  const auto positions = triangles_at({{0, -1}, {0, -3}});
  const glm::mat4 turned = glm::rotate(glm::translate(glm::mat4(1.0f), {0, 0, -5}), 3.14159265f, glm::vec3(0, 1, 0));
  EXPECT_EQ(far_to_near(in_order({0, 1}), positions, turned, {}), in_order({0, 1}));
  EXPECT_EQ(far_to_near(in_order({0, 1}), positions, turned, {.eye = {0, 0, -20}}), in_order({1, 0}));
}

// The second is nearer to the eye, the first to the plane that an orthographic camera looks through.
TEST(TriangleOrder, OrthographicCamerasMeasureAlongTheirAxis) {
  const auto positions = triangles_at({{9, -2}, {0, -3}});
  EXPECT_EQ(far_to_near(in_order({0, 1}), positions, glm::mat4(1.0f), {}), in_order({0, 1}));
  EXPECT_EQ(far_to_near(in_order({0, 1}), positions, glm::mat4(1.0f), {.backward = {0, 0, 1}}), in_order({1, 0}));
}

TEST(TriangleOrder, NearAndBehindTheEyeOfAnOrthographicCamera) {
  const auto positions = triangles_at({{0, 2}, {0, -0.5f}, {0, 0.5f}});
  EXPECT_EQ(far_to_near(in_order({0, 1, 2}), positions, glm::mat4(1.0f), {.backward = {0, 0, 1}}), in_order({1, 2, 0}));
}

}  // namespace
}  // namespace velarium::upload
