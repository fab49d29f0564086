#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/shading/support.hpp"

namespace velarium::shading {
namespace {

struct View {
  vec4 ndc_to_view;
  float perspective;
};

const View kPerspective{{1.0264f, -0.57735f, 0.0f, 0.0f}, 1.0f};
const View kOffAxis{{1.0264f, -0.57735f, 0.3f, -0.2f}, 1.0f};
const View kOrthographic{{12.0f, -7.0f, 0.5f, 1.0f}, 0.0f};

struct Tile {
  vec2 ndc_min, ndc_max;
  float z_min, z_max;
  TileVolume volume;
};

Tile random_tile(Random& random, const View& view) {
  Tile t;
  t.ndc_min = {random.uniform(-1.0f, 0.9f), random.uniform(-1.0f, 0.9f)};
  t.ndc_max = t.ndc_min + vec2(random.uniform(0.005f, 0.1f), random.uniform(0.005f, 0.1f));
  t.z_min = std::exp(random.uniform(-2.0f, 4.0f));
  t.z_max = t.z_min + (random.uniform() < 0.1f ? 0.0f : std::exp(random.uniform(-4.0f, 4.0f)));
  t.volume = tile_volume(t.ndc_min, t.ndc_max, t.z_min, t.z_max, view.ndc_to_view, view.perspective);
  return t;
}

vec3 random_point(Random& random, const Tile& t, const View& view, float nearest) {
  const vec2 ndc = mix(t.ndc_min, t.ndc_max, vec2(random.uniform(), random.uniform()));
  return view_position(ndc, mix(nearest, t.z_max, random.uniform()), view.ndc_to_view, view.perspective);
}

// Lights made to reach a point of the tile, some by a hair: none may be refused.
TEST(TileCulling, NeverRefusesALightThatReachesTheTile) {
  Random random(21);
  for (const View& view : {kPerspective, kOffAxis, kOrthographic}) {
    for (int i = 0; i < 200000; ++i) {
      const Tile t = random_tile(random, view);
      const float radius = std::exp(random.uniform(-4.0f, 5.0f));
      const float reach = i % 2 == 0 ? random.uniform() : 1.0f;
      const vec3 offset = random.direction() * (radius * reach);
      ASSERT_TRUE(tile_overlaps_sphere(t.volume, random_point(random, t, view, t.z_min) + offset, radius));
      ASSERT_TRUE(tile_overlaps_sphere_no_near(t.volume, random_point(random, t, view, 0.0f) + offset, radius));
    }
  }
}

TEST(TileCulling, KeepsLightsWithoutEnd) {
  Random random(22);
  for (const View& view : {kPerspective, kOrthographic}) {
    for (int i = 0; i < 1000; ++i) {
      const Tile t = random_tile(random, view);
      const vec3 center = random.direction() * 100.0f;
      ASSERT_TRUE(tile_overlaps_sphere(t.volume, center, kUnboundedRadius));
      ASSERT_TRUE(tile_overlaps_sphere_no_near(t.volume, center, kUnboundedRadius));
    }
  }
}

// Exact distance from a point to a tile of an on-axis perspective view, by search over depth.
double exact_distance(const Tile& t, const View& view, const vec3& p) {
  const glm::dvec2 a = view_position_xy(t.ndc_min, 1.0f, view.ndc_to_view, 1.0f);
  const glm::dvec2 b = view_position_xy(t.ndc_max, 1.0f, view.ndc_to_view, 1.0f);
  const glm::dvec2 low = glm::min(a, b), high = glm::max(a, b), xy{p.x, p.y};
  const auto distance2 = [&](double z) {
    const glm::dvec2 outside = glm::max(glm::max(low * z - xy, xy - high * z), glm::dvec2(0.0));
    return glm::dot(outside, outside) + (z + p.z) * (z + p.z);
  };
  double near = t.z_min, far = t.z_max;
  for (int i = 0; i < 60; ++i) {
    const double u = near + (far - near) / 3.0, v = far - (far - near) / 3.0;
    (distance2(u) < distance2(v) ? far : near) = distance2(u) < distance2(v) ? v : u;
  }
  return std::sqrt(distance2(0.5 * (near + far)));
}

struct Counts {
  int hits = 0, false_hits = 0, misses = 0;
};

// 16-pixel tiles at 1080p about lights of 1 to 6 m at 8 to 40 m, the tile's depth range beginning near the light.
Counts count_false_hits(float depth_range) {
  Random random(11);
  Counts counts;
  for (int i = 0; i < 400000; ++i) {
    const float z = random.uniform(8.0f, 40.0f), radius = random.uniform(1.0f, 6.0f);
    const vec2 center{random.uniform(-0.7f, 0.7f), random.uniform(-0.7f, 0.7f)};
    const vec3 light = view_position(center, z, kPerspective.ndc_to_view, 1.0f);
    const float spread = 1.3f * radius / z;
    const float x = std::floor((center.x + random.uniform(-spread, spread)) * 60.0f) / 60.0f;
    const float y = std::floor((center.y + random.uniform(-2.0f, 2.0f) * spread) * 33.75f) / 33.75f;
    Tile t{{x, y}, {x + 1.0f / 60.0f, y + 1.0f / 33.75f}, 0.0f, 0.0f, {}};
    t.z_min = std::max(0.5f, z + random.uniform(-1.5f, 1.2f) * radius);
    t.z_max = t.z_min + depth_range;
    t.volume = tile_volume(t.ndc_min, t.ndc_max, t.z_min, t.z_max, kPerspective.ndc_to_view, 1.0f);
    const bool hit = exact_distance(t, kPerspective, light) <= radius;
    const bool kept = tile_overlaps_sphere(t.volume, light, radius);
    counts.hits += hit;
    counts.false_hits += kept && !hit;
    counts.misses += hit && !kept;
  }
  return counts;
}

// Planes alone: 95 % and 56 %; box alone: 4.6 % and 58 %.
TEST(TileCulling, KeepsFewLightsInVain) {
  const Counts shallow = count_false_hits(0.5f), deep = count_false_hits(20.0f);
  EXPECT_EQ(shallow.misses, 0);
  EXPECT_EQ(deep.misses, 0);
  EXPECT_GT(shallow.hits, 10000);
  EXPECT_NEAR(static_cast<double>(shallow.false_hits) / shallow.hits, 0.041, 0.01);
  EXPECT_NEAR(static_cast<double>(deep.false_hits) / deep.hits, 0.176, 0.03);
}

TEST(TileCulling, PlanesAreInwardAndUnit) {
  Random random(23);
  for (const View& view : {kPerspective, kOffAxis, kOrthographic}) {
    const Tile t = random_tile(random, view);
    const vec3 inside =
        view_position(0.5f * (t.ndc_min + t.ndc_max), 0.5f * (t.z_min + t.z_max), view.ndc_to_view, view.perspective);
    for (const vec4& plane : t.volume.planes) {
      const vec3 n{plane.x, plane.y, plane.z};
      EXPECT_NEAR(length(n), 1.0f, 1e-6);
      EXPECT_GT(dot(n, inside) + plane.w, 0.0f);
    }
  }
}

TEST(DepthMask, LeavesOutLightsInEmptySpace) {
  uint geometry = 0;
  for (const float z : {5.0f, 5.2f, 5.5f, 48.0f, 49.0f, 50.0f}) geometry |= depth_mask_bit(z, 5.0f, 50.0f);
  EXPECT_EQ(geometry, 0xc0000001u);
  EXPECT_EQ(depth_mask_range(15.0f, 35.0f, 5.0f, 50.0f), 0x003fff80u);
  EXPECT_EQ(depth_mask_range(1.0f, 4.9f, 5.0f, 50.0f), 0u);
  EXPECT_EQ(depth_mask_range(51.0f, 60.0f, 5.0f, 50.0f), 0u);
  EXPECT_EQ(depth_mask_range(0.0f, 100.0f, 5.0f, 50.0f), 0xffffffffu);
  EXPECT_EQ(depth_mask_range(-kUnboundedRadius, kUnboundedRadius, 5.0f, 50.0f), 0xffffffffu);
  EXPECT_EQ(depth_mask_bit(5.0f, 5.0f, 5.0f) & depth_mask_range(4.0f, 6.0f, 5.0f, 5.0f), 1u);
}

TEST(DepthMask, NeverRefusesALightAtASurface) {
  Random random(24);
  for (int i = 0; i < 200000; ++i) {
    const float z_min = std::exp(random.uniform(-3.0f, 5.0f)), z_max = z_min + std::exp(random.uniform(-9.0f, 6.0f));
    const float z = std::clamp(mix(z_min, z_max, random.uniform()), z_min, z_max);
    const float l_min = i % 3 == 0 ? z : z - random.uniform(0.0f, 5.0f);
    const float l_max = i % 3 == 1 ? z : z + random.uniform(0.0f, 5.0f);
    ASSERT_NE(depth_mask_bit(z, z_min, z_max) & depth_mask_range(l_min, l_max, z_min, z_max), 0u);
  }
}

TEST(SpotSphere, KnownSizes) {
  const auto sphere = [](double degrees) {
    return spot_bounding_sphere(vec3(0.0f), vec3(0, 0, -1), 1.0f, static_cast<float>(std::cos(radians(degrees))));
  };
  EXPECT_NEAR(sphere(20.0).w, 0.532f, 5e-4);
  EXPECT_NEAR(sphere(20.0).z, -0.532f, 5e-4);
  EXPECT_NEAR(sphere(45.0).w, 0.707f, 5e-4);
  EXPECT_NEAR(sphere(60.0).w, 0.866f, 5e-4);
  EXPECT_NEAR(sphere(60.0).z, -0.5f, 5e-4);
  EXPECT_NEAR(sphere(90.0).w, 1.0f, 5e-4);
}

TEST(SpotSphere, HoldsTheCone) {
  Random random(25);
  for (int i = 0; i < 200000; ++i) {
    const vec3 apex = random.direction() * random.uniform(0.0f, 300.0f), axis = random.direction();
    const float range = std::exp(random.uniform(-2.0f, 6.0f)), cos_outer = random.uniform(0.0f, 0.9999f);
    const vec4 sphere = spot_bounding_sphere(apex, axis, range, cos_outer);
    // The rim, the apex, and what lies between.
    const float cosine = i % 2 == 0 ? cos_outer : random.uniform(cos_outer, 1.0f);
    const float phi = random.uniform(0.0f, kTwoPi), sine = std::sqrt(1.0f - cosine * cosine);
    const vec3 d = from_tangent_space(vec3(sine * std::cos(phi), sine * std::sin(phi), cosine), axis);
    const glm::dvec3 p = glm::dvec3(apex) + glm::dvec3(d) * static_cast<double>(range * (i % 5 == 0 ? 0.0f : 1.0f));
    ASSERT_LE(glm::length(p - glm::dvec3(sphere.x, sphere.y, sphere.z)), sphere.w);
  }
  EXPECT_EQ(spot_bounding_sphere(vec3(1, 2, 3), vec3(1, 0, 0), kUnboundedRadius, 0.9f),
            vec4(1, 2, 3, kUnboundedRadius));
}

TEST(SpotCone, NeverRefusesASphereThatItReaches) {
  Random random(26);
  for (int i = 0; i < 200000; ++i) {
    const vec3 apex = random.direction() * random.uniform(0.0f, 300.0f), axis = random.direction();
    const float cos_outer = i % 7 == 0 ? 0.0f : random.uniform(0.0f, 0.9999f);
    const float cosine = i % 2 == 0 ? cos_outer : random.uniform(cos_outer, 1.0f);  // the side, or within
    const float phi = random.uniform(0.0f, kTwoPi), sine = std::sqrt(1.0f - cosine * cosine);
    const vec3 d = from_tangent_space(vec3(sine * std::cos(phi), sine * std::sin(phi), cosine), axis);
    const vec3 lit = apex + d * (i % 5 == 0 ? 0.0f : std::exp(random.uniform(-3.0f, 5.0f)));
    const float radius = std::exp(random.uniform(-5.0f, 3.0f));
    const vec3 center = lit + random.direction() * (radius * (i % 3 == 0 ? 1.0f : random.uniform()));
    ASSERT_TRUE(cone_overlaps_sphere(apex, axis, cos_outer, vec4(center, radius))) << i;
  }
}

TEST(SpotCone, LeavesOutWhatIsBesideAndBehind) {
  const vec3 apex(1.0f, 2.0f, 3.0f), axis(0.0f, 0.0f, -1.0f);
  const float cos_outer = std::cos(static_cast<float>(radians(30.0)));
  const auto reaches = [&](const vec3& from_apex, float radius) {
    return cone_overlaps_sphere(apex, axis, cos_outer, vec4(apex + from_apex, radius));
  };
  EXPECT_TRUE(reaches(vec3(0.0f, 0.0f, -10.0f), 0.01f));
  EXPECT_TRUE(reaches(vec3(5.7f, 0.0f, -10.0f), 0.01f));   // tan 30 = 0.577
  EXPECT_FALSE(reaches(vec3(5.9f, 0.0f, -10.0f), 0.05f));  // 0.11 beside
  EXPECT_TRUE(reaches(vec3(5.9f, 0.0f, -10.0f), 0.2f));
  EXPECT_FALSE(reaches(vec3(0.0f, 0.0f, 1.0f), 0.9f));
  EXPECT_TRUE(reaches(vec3(0.0f, 0.0f, 1.0f), 1.1f));
}

// What a tile's volume holds, its sphere holds.
TEST(SpotCone, SphereOfATileHoldsIt) {
  Random random(27);
  for (const View& view : {kPerspective, kOffAxis, kOrthographic}) {
    for (int i = 0; i < 10000; ++i) {
      const Tile t = random_tile(random, view);
      const vec4 sphere = tile_bounding_sphere(t.volume);
      const vec3 inside = random_point(random, t, view, t.z_min);
      ASSERT_LE(length(inside - vec3(sphere.x, sphere.y, sphere.z)), sphere.w * 1.00001f + 1e-6f * length(inside));
    }
  }
}

// Spots about tiles of 16 pixels at 1080p, as count_false_hits() has lights; what is lit in a tile is looked for at
// points of it.
struct SpotCounts {
  int lit = 0, by_sphere = 0, kept = 0, missed = 0;
};

SpotCounts count_spots_before(float z_max) {
  Random random(31);
  SpotCounts counts;
  for (int i = 0; i < 20000; ++i) {
    const float z = random.uniform(-3.0f, 30.0f), range = random.uniform(1.0f, 6.0f);
    const float cos_outer = std::cos(random.uniform(0.2f, 1.2f));
    const vec3 apex(random.uniform(-0.5f, 0.5f) * z, random.uniform(-0.3f, 0.3f) * z, -z), axis = random.direction();
    const vec4 bounds = spot_bounding_sphere(apex, axis, range, cos_outer);
    const vec2 low(random.uniform(-1.0f, 1.0f), random.uniform(-1.0f, 1.0f));
    const vec2 high = low + vec2(1.0f / 60.0f, 1.0f / 33.75f);
    const vec3 center(bounds.x, bounds.y, bounds.z);
    const auto before = tile_volume(low, high, 0.0f, z_max, kPerspective.ndc_to_view, 1.0f);
    if (!tile_overlaps_sphere_no_near(before, center, bounds.w)) continue;
    ++counts.by_sphere;
    const bool kept =
        spot_reaches_before(bounds, apex, axis, cos_outer, low, high, z_max, kPerspective.ndc_to_view, 1.0f);
    counts.kept += kept;
    const float from = std::max(-center.z - bounds.w, 0.0f), to = std::min(-center.z + bounds.w, z_max);
    bool lit = false;
    for (int k = 0; k < 400 && !lit && to > from; ++k) {
      const vec2 ndc(random.uniform(low.x, high.x), random.uniform(low.y, high.y));
      const vec3 way = view_position(ndc, random.uniform(from, to), kPerspective.ndc_to_view, 1.0f) - apex;
      lit = length(way) < range && dot(way, axis) > cos_outer * length(way);
    }
    counts.lit += lit;
    counts.missed += lit && !kept;
  }
  return counts;
}

TEST(SpotCone, TransparentSurfacesAskFewSpotsInVain) {
  for (const float z_max : {kUnboundedRadius, 15.0f}) {
    const SpotCounts counts = count_spots_before(z_max);
    EXPECT_EQ(counts.missed, 0) << z_max;
    EXPECT_GT(counts.lit, 100) << z_max;
    RecordProperty("lit", counts.lit);
    RecordProperty("by_sphere", counts.by_sphere);
    RecordProperty("kept", counts.kept);
    EXPECT_LT(counts.kept - counts.lit, (counts.by_sphere - counts.lit) / 2) << z_max;
  }
}

// Behind the eye and turned away from it; beyond the surface that the tile shows; and, without an end, kept for want of
// bounds.
TEST(SpotCone, TransparentSurfacesDoNotAskSpotsBehind) {
  const auto reaches = [](const vec3& apex, const vec3& axis, float range, float z_max) {
    return spot_reaches_before(spot_bounding_sphere(apex, axis, range, 0.8f), apex, axis, 0.8f, vec2(0.0f), vec2(0.02f),
                               z_max, kPerspective.ndc_to_view, 1.0f);
  };
  const vec3 backwards(0, 0, 1), forwards(0, 0, -1);
  EXPECT_FALSE(reaches(vec3(0, 0, 0.5f), backwards, 8.0f, kUnboundedRadius));
  EXPECT_TRUE(reaches(vec3(0, 0, 0.5f), forwards, 8.0f, kUnboundedRadius));
  EXPECT_FALSE(reaches(vec3(0, 0, -12.0f), forwards, 8.0f, 10.0f));
  EXPECT_TRUE(reaches(vec3(0, 0, -12.0f), backwards, 8.0f, 10.0f));
  EXPECT_FALSE(reaches(vec3(3, 0, -5), vec3(1, 0, 0), 8.0f, kUnboundedRadius));
  EXPECT_TRUE(reaches(vec3(3, 0, -5), vec3(-1, 0, 0), 8.0f, kUnboundedRadius));
  EXPECT_TRUE(reaches(vec3(0, 0, 0.5f), forwards, kUnboundedRadius, kUnboundedRadius));
}

}  // namespace
}  // namespace velarium::shading
