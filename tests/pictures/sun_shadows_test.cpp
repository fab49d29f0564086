// Shadows of the sun, held against geometry: where they begin, how wide their edges are, and that nothing shadows
// itself.

#include "sun_shade.hpp"
#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"
#include "support/settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace velarium::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

RenderRequest request(std::uint32_t size, const std::string& options) {
  RenderRequest request = linear_request(size, size);
  set_options(request.settings, options);
  return request;
}

// Seen from above: columns along +z, rows from +x down to -x, `half` metres each way.
void look_down(GltfWriter& scene, float height, float half) {
  scene.add_orthographic_camera({0, height, 0}, {0, 0, 0}, half, 100.0f);
}

// A plane that turns away from the sun shows no shadow of its own, in maps so coarse that a texel spans many pixels.
TEST(SunShadow, NoPlaneShadowsItself) {
  for (const float tilt : {0.0f, 20.0f, 45.0f, 60.0f, 70.0f, 80.0f, 85.0f}) {
    const Scene plane = tilted_plane(tilt);
    for (const char* soft : {"on", "off"})
      EXPECT_GT(darkest_on_plane(plane, std::string("sun_shadows.size=128 sun_shadows.soft=") + soft), 0.999f)
          << tilt << " degrees, soft " << soft;
  }
}

// A wall that looks away from the sun, into the room that it belongs to, keeps the sun out.
TEST(SunShadow, BothSidesOfSurfacesCastShadows) {
  for (const float side : {-1.0f, 1.0f}) {
    GltfWriter scene;
    const int matt = scene.add_material({});
    scene.add_quad(matt, {0, 0, 0}, {0, 1, 0}, {8, 8});
    scene.add_quad(matt, {0, 1, 0}, {0, side, 0}, {1, 1});
    scene.add_light({.type = "directional", .intensity = 10.0f, .direction = {-1, -1, 0}});
    look_down(scene, 3.0f, 2.0f);
    constexpr std::uint32_t kSize = 64;
    const auto share = shadow_of(scene.load(), request(kSize, "sun_shadows.size=512"));
    // The shadow's middle is at x = -1, three quarters down the middle column.
    EXPECT_EQ(share[std::size_t{48} * kSize + kSize / 2], 0.0f) << side;
  }
}

// Shadows begin at the foot of what casts them: within twice what the receiver is lifted by.
TEST(SunShadow, TouchesTheFootOfABox) {
  GltfWriter scene;
  const int matt = scene.add_material({});
  scene.add_quad(matt, {0, 0, 0}, {0, 1, 0}, {4, 4});
  scene.add_box(matt, {0, 0.05f, 0}, {0.1f, 0.1f, 0.1f});
  scene.add_light({.type = "directional", .intensity = 10.0f, .direction = {-1, -1, 0}});
  look_down(scene, 3.0f, 0.24f);
  constexpr std::uint32_t kSize = 96;
  constexpr double kPixel = 0.48 / kSize;
  const auto share = shadow_of(scene.load(), request(kSize, "sun_shadows.size=512"));
  // The middle column, from the box's edge at x = -0.05 downwards in the picture.
  const auto at = [&](double x) { return share[static_cast<std::size_t>((0.24 - x) / kPixel) * kSize + kSize / 2]; };
  // One map holds the scene: a sphere of radius 2.83 m about it, hence texels of 1.1 cm.
  constexpr double kTexel = 2.0 * 2.83 / 512, kLift = 2.5 * kTexel;
  double begins = -0.05;
  while (begins > -0.2 && at(begins - 0.5 * kPixel) > 0.5f) begins -= kPixel;
  EXPECT_LT(-0.05 - begins, 2.0 * kLift);
  // It ends where the upper edge throws it, 10 cm farther out, but for the filter's texel and the lift.
  double ends = -0.14;
  while (ends > -0.23 && at(ends - 0.5 * kPixel) < 0.5f) ends -= kPixel;
  EXPECT_NEAR(ends, -0.15, 2.0 * kLift);
  EXPECT_EQ(at(0.2), 1.0f);
}

// The share of a disc of radius 1 that lies left of x.
double disc_left_of(double x) {
  const double c = std::clamp(x, -1.0, 1.0);
  return 1.0 - (std::acos(c) - c * std::sqrt(1.0 - c * c)) / kPi;
}

// Light past the edge of a half plane, which hangs above x < 0 with the sun in the zenith: as much as of the sun's disc
// stands clear of the edge.
TEST(SunShadow, EdgesAreAsWideAsTheSunMakesThem) {
  constexpr float kAngle = 0.05f;
  constexpr std::uint32_t kSize = 64;
  constexpr double kHalf = 0.4;
  double sum_xy = 0.0, sum_xx = 0.0;
  for (const float height : {2.0f, 4.0f, 6.0f}) {
    GltfWriter scene;
    const int matt = scene.add_material({.double_sided = true});
    scene.add_quad(matt, {0, 0, 0}, {0, 1, 0}, {8, 8});
    scene.add_quad(matt, {-2, height, 0}, {0, 1, 0}, {8, 4});
    scene.add_light(
        {.type = "directional", .intensity = 10.0f, .direction = {0, -1, 0}, .extras = {{"angular_radius", kAngle}}});
    look_down(scene, 1.0f, static_cast<float>(kHalf));
    RenderRequest view = request(kSize, "frame.spp=16");
    const auto share = shadow_of(scene.load(), view);
    const double radius = static_cast<double>(height) * std::tan(static_cast<double>(kAngle));
    double worst = 0.0, tenth = 0.0, nine_tenths = 0.0;
    for (std::uint32_t row = 0; row < kSize; ++row) {
      double mean = 0.0;
      for (std::uint32_t column = 0; column < kSize; ++column)
        mean += static_cast<double>(share[std::size_t{row} * kSize + column]) / kSize;
      const double x = kHalf - (row + 0.5) * 2.0 * kHalf / kSize;
      worst = std::max(worst, std::abs(mean - disc_left_of(x / radius)));
      if (mean > 0.9) nine_tenths = x;
      if (mean > 0.1) tenth = x;
    }
    EXPECT_LT(worst, 0.05) << height;
    const double y = nine_tenths - tenth, h = static_cast<double>(height);
    sum_xy += h * y;
    sum_xx += h * h;
  }
  // 10 and 90 per cent of a disc lie left of -0.687 and 0.687.
  const double slope = 2.0 * 0.687 * std::tan(static_cast<double>(kAngle));
  EXPECT_NEAR(sum_xy / sum_xx, slope, 0.05 * slope);
}

// The viewer moves by whole pixels, which are no whole texels: what stands still in the world keeps its shadow.
TEST(SunShadow, EdgesStayWhereTheyAreWhenTheViewerMoves) {
  constexpr std::uint32_t kSize = 96;
  constexpr float kHalf = 1.2f, kPixel = 2.0f * kHalf / kSize;
  constexpr std::uint32_t kShift = 13;
  const auto seen_from = [&](float z) {
    GltfWriter scene;
    const int matt = scene.add_material({});
    scene.add_quad(matt, {0, 0, 0}, {0, 1, 0}, {60, 60});
    for (int i = -3; i <= 3; ++i)
      scene.add_box(matt, {0.3f * static_cast<float>(i), 0.1f, 0.37f * static_cast<float>(i)}, {0.15f, 0.2f, 0.1f});
    scene.add_light({.type = "directional", .intensity = 10.0f, .direction = {-0.5f, -1, 0.3f}});
    scene.add_orthographic_camera({0, 3, z}, {0, 0, z}, kHalf, 100.0f);
    return shadow_of(scene.load(), request(kSize, "sun_shadows.size=512 sun_shadows.taps=64 sun_shadows.cascades=2"));
  };
  const auto before = seen_from(0.0f), after = seen_from(kPixel * kShift);
  std::uint32_t shadowed = 0, changed = 0;
  for (std::uint32_t y = 0; y < kSize; ++y)
    for (std::uint32_t x = kShift; x < kSize; ++x) {
      const float was = before[y * kSize + x], is = after[y * kSize + x - kShift];
      shadowed += was < 0.5f ? 1 : 0;
      changed += std::abs(was - is) > 0.25f ? 1 : 0;
    }
  EXPECT_GT(shadowed, 150u);
  // The kernel's turn goes with the pixel, so that a few pixels of an edge differ by one tap or two.
  EXPECT_LE(changed, shadowed / 50);
}

// A view that jumps finds all maps drawn anew, and one that stays sees the same whether its maps were kept or not.
TEST(SunShadow, KeptMapsShowWhatNewOnesWould) {
  GltfWriter scene;
  const int matt = scene.add_material({});
  scene.add_quad(matt, {0, 0, 0}, {0, 1, 0}, {200, 200});
  for (int i = -20; i <= 20; ++i)
    scene.add_box(matt, {3.0f * static_cast<float>(i), 0.5f, 2.0f * static_cast<float>(i % 5)}, {0.8f, 1.0f, 0.5f});
  scene.add_light({.type = "directional", .intensity = 10.0f, .direction = {-0.5f, -1, 0.3f}});
  const Scene loaded = scene.load();
  const auto seen_from = [](float x) {
    RenderRequest view = request(64, "sun_shadows.size=256 sun_shadows.update=staggered sun_shadows.cascades=6");
    view.look_at = LookAt{.eye = {x, 2, 6}, .target = {x, 0, 0}};
    return view;
  };
  Engine moving(validated()), fresh(validated());
  const auto first = moving.picture(loaded, seen_from(0.0f));
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(largest_error(moving.picture(loaded, seen_from(0.0f)).linear, first.linear), 0.0);
  EXPECT_GT(largest_error(moving.picture(loaded, seen_from(0.1f)).linear, first.linear), 0.1);
  const auto far_away = moving.picture(loaded, seen_from(50.0f));
  EXPECT_EQ(largest_error(far_away.linear, fresh.picture(loaded, seen_from(50.0f)).linear), 0.0);
}

// Transparent surfaces look into the maps themselves; at alpha 1 they get what the mask says of opaque ones.
TEST(SunShadow, IsTheSameOnTransparentSurfaces) {
  const auto plane = [](const char* alpha_mode) {
    GltfWriter scene;
    scene.add_quad(scene.add_material({.alpha_mode = alpha_mode}), {0, 0, 0}, {0, 1, 0}, {4, 4});
    scene.add_box(scene.add_material({}), {0, 1.5f, 0}, {0.6f, 0.1f, 0.4f});
    scene.add_light({.type = "directional",
                     .intensity = 3.0f,
                     .direction = {-0.3f, -1, 0.2f},
                     .extras = {{"angular_radius", 0.02f}}});
    look_down(scene, 1.0f, 1.0f);
    return scene.load();
  };
  const auto opaque = shadow_of(plane("OPAQUE"), request(64, "")), blended = shadow_of(plane("BLEND"), request(64, ""));
  ASSERT_EQ(opaque.size(), blended.size());
  double difference = 0.0, dark = 0.0;
  for (std::size_t i = 0; i < opaque.size(); ++i) {
    difference += static_cast<double>(std::abs(opaque[i] - blended[i]));
    dark += 1.0 - static_cast<double>(opaque[i]);
  }
  EXPECT_GT(dark, 100.0);
  EXPECT_LT(difference, 0.02 * dark);
}

}  // namespace
}  // namespace velarium::test
