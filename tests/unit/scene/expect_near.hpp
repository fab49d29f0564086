#pragma once

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace velarium::scene::test {

// tolerance: of the distance; what some products of numbers of a few metres lose in fp32.
inline void expect_near(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-6f) {
  EXPECT_LE(glm::length(a - b), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z;
}

}  // namespace velarium::scene::test
