#include "passes/local_shadows/nearest_caster.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace velarium::local_shadows {
namespace {

constexpr double kNearest = 0.01, kFarthest = 50.0;

// One triangle, (0, 0, 0), (4, 0, 0), (0, 4, 0), of an object that is moved by `to`.
struct OneTriangle {
  std::vector<glm::vec3> positions{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  std::vector<std::uint32_t> indices{0, 1, 2};
  upload::CasterTable table;

  explicit OneTriangle(const glm::vec3& to, const glm::dvec3& eye = {},
                       upload::CasterKind kind = upload::CasterKind::opaque) {
    scene::Instance instance;
    instance.world_from_object = glm::translate(glm::mat4(1.0f), to);
    table.casters.push_back(
        {.bounds = {to, to + glm::vec3(4, 4, 0)}, .kind = kind, .indices = indices, .positions = positions});
    table.objects.push_back(upload::object_data(instance, eye));
  }
  [[nodiscard]] double from(const glm::dvec3& position, const glm::dvec3& eye = {}, bool translucent = true) const {
    return nearest_caster(table, eye, position, kNearest, kFarthest, translucent);
  }
};

TEST(NearestCaster, IsTheFootOnAPlaneAnEdgeOrACorner) {
  const OneTriangle triangle({0, 0, 0});
  EXPECT_NEAR(triangle.from({1, 1, 3}), 3.0, 1e-5);
  EXPECT_NEAR(triangle.from({1, 1, -3}), 3.0, 1e-5);
  EXPECT_NEAR(triangle.from({2, -3, 4}), 5.0, 1e-5);            // the edge below
  EXPECT_NEAR(triangle.from({3, 3, 0}), std::sqrt(2.0), 1e-5);  // the long edge
  EXPECT_NEAR(triangle.from({-1, -2, 2}), 3.0, 1e-5);           // a corner
  EXPECT_NEAR(triangle.from({7, -4, 0}), 5.0, 1e-5);            // another
}

TEST(NearestCaster, PlacesAreRelativeToTheEye) {
  const glm::dvec3 eye(100, 0, 0);
  const OneTriangle triangle({98, 0, 0}, eye);
  EXPECT_NEAR(triangle.from({-1, 1, 3}, eye), 3.0, 1e-5);
}

TEST(NearestCaster, StaysWithinItsLimits) {
  const OneTriangle triangle({0, 0, 0});
  EXPECT_EQ(triangle.from({1, 1, 0.001}), kNearest);
  EXPECT_NEAR(triangle.from({1, 1, 80}), kFarthest, 1e-5);
}

TEST(NearestCaster, TranslucentOnesCountWhereTheyThrowShadows) {
  const OneTriangle triangle({0, 0, 0}, {}, upload::CasterKind::translucent);
  EXPECT_NEAR(triangle.from({1, 1, 3}), 3.0, 1e-5);
  EXPECT_NEAR(triangle.from({1, 1, 3}, {}, false), kFarthest, 1e-5);
}

TEST(NearestCaster, LinesThatShouldBeTrianglesAreNoTrouble) {
  OneTriangle flat({0, 0, 0});
  flat.indices = {0, 1, 1};
  flat.table.casters[0].indices = flat.indices;
  EXPECT_NEAR(flat.from({2, 3, 0}), 3.0, 1e-5);
}

// A box around the light says nothing of how far its surfaces are.
TEST(NearestCaster, ALightInsideTheBoxOfACasterIsAsFarAsItsTriangles) {
  const OneTriangle triangle({0, 0, 0});
  EXPECT_NEAR(triangle.from({3.5, 3.5, 0}), 1.5 * std::sqrt(2.0), 1e-5);
}

}  // namespace
}  // namespace velarium::local_shadows
