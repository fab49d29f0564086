#include <gtest/gtest.h>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

TEST(ClipVolume, RecordsTellWhereThePlanesAre) {
  const ClipPlanes planes = clip_planes(vec4(7.0f, 6.0f, 0.0f, 0.0f));
  EXPECT_EQ(planes.first, 7u);
  EXPECT_EQ(planes.count, 6u);
}

TEST(ClipVolume, PlanesHoldWhatIsBeforeThem) {
  const vec4 plane(1.0f, 0.0f, 0.0f, -2.0f);
  EXPECT_TRUE(before_clip_plane(plane, vec3(2.5f, 9.0f, 9.0f)));
  EXPECT_TRUE(before_clip_plane(plane, vec3(2.0f, 9.0f, 9.0f)));
  EXPECT_FALSE(before_clip_plane(plane, vec3(1.999f, 9.0f, 9.0f)));
}

// A thin wall at x = 10 in a plane of the volume x <= 10, seen from five metres beside, its depth rounded either way.
TEST(ClipVolume, OfAWallInThePlaneTheSideThatFacesInIsInside) {
  const vec4 plane(-1.0f, 0.0f, 0.0f, 10.0f);
  for (const float rounding : {-1e-5f, 0.0f, 1e-5f}) {
    const vec3 on_wall(10.0f + rounding, 0.0f, -5.0f);
    EXPECT_TRUE(before_clip_plane(plane, clip_point(on_wall, vec3(-1.0f, 0.0f, 0.0f))));
    EXPECT_FALSE(before_clip_plane(plane, clip_point(on_wall, vec3(1.0f, 0.0f, 0.0f))));
  }
}

}  // namespace
}  // namespace velarium::shading
