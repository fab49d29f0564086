// The sun's shadows where no cascade reaches: there, from a map of the whole scene, and nothing where all is covered.

#include "sun_shade.hpp"
#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"
#include "support/settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace velarium::test {
namespace {

constexpr std::uint32_t kSize = 64;
// All that a viewer a metre away sees lies beyond one small cascade.
const std::string kBeyond = "sun_shadows.size=256 sun_shadows.cascades=1 sun_shadows.distance=0.01 ";
const std::string kVsm = kBeyond + "far_shadows.kind=vsm far_shadows.size=512 ";
const std::string kStatic = kBeyond + "far_shadows.kind=static_map far_shadows.static_size=1024 ";
const std::string kStaggered = "sun_shadows.update=staggered ";

RenderRequest request(const std::string& options) {
  RenderRequest request = linear_request(kSize, kSize);
  set_options(request.settings, options);
  return request;
}

// A roof of two metres above a floor of eight, under a sun that leans towards -x by its slope. A camera looks down,
// from so high that no cascade of kBeyond reaches the floor.
struct Roof {
  std::string alpha_mode = "OPAQUE";  // of the floor
  float slope = 0.5f;
  float z = 0.0f;  // of the roof

  [[nodiscard]] Scene load() const {
    GltfWriter scene;
    const int matt = scene.add_material({.double_sided = true});
    scene.add_quad(scene.add_material({.alpha_mode = alpha_mode}), {0, 0, 0}, {0, 1, 0}, {8, 8});
    scene.add_quad(matt, {0, 1, z}, {0, 1, 0}, {2, 2});
    scene.add_light({.type = "directional", .intensity = 3.0f, .direction = {-slope, -1, 0}});
    scene.add_orthographic_camera({0, 20, 0}, {0, 0, 0}, 2.0f, 40.0f);
    return scene.load();
  }
};

// Columns along +z, rows from x = 2 down to -2: where the shadow ends that is seen past the roof's edge at x = -1.
double shadow_edge(const std::vector<float>& share) {
  const double pixel = 4.0 / kSize;
  double dark = 0.0;
  for (std::uint32_t row = 0; row < kSize; ++row) {
    const double x = 2.0 - (row + 0.5) * pixel;
    if (x < -1.0) dark += pixel * (1.0 - static_cast<double>(share[std::size_t{row} * kSize + kSize / 2]));
  }
  return -1.0 - dark;
}

TEST(FarShadow, FallsWhereGeometrySays) {
  const Scene roof = Roof{}.load();
  EXPECT_EQ(shadow_edge(shadow_of(roof, request(kBeyond + "far_shadows.kind=off"))), -1.0);
  // Its texels are 1.8 and 0.9 cm; the moments' light begins at a fifth of the bound, some tenths of a texel later.
  EXPECT_NEAR(shadow_edge(shadow_of(roof, request(kVsm))), -1.5, 0.02);
  EXPECT_NEAR(shadow_edge(shadow_of(roof, request(kStatic))), -1.5, 0.02);
}

// A plane that turns away from the sun shows no shadow of its own, in maps so coarse that a texel spans many pixels.
TEST(FarShadow, NoPlaneShadowsItself) {
  for (const float tilt : {0.0f, 30.0f, 60.0f, 80.0f, 85.0f}) {
    const Scene plane = tilted_plane(tilt);
    for (const auto& options : {kVsm + "far_shadows.size=128", kStatic + "far_shadows.static_size=128"})
      EXPECT_GT(darkest_on_plane(plane, options), 0.999f) << tilt << " degrees, " << options;
  }
}

// A kilometre of depth in 16 bits has steps of 15 mm, which are two texels wide here: the lift that goes by texels does
// not hide them.
TEST(FarShadow, DeepScenesDoNotShowTheirSteps) {
  for (const float slope : {0.0f, 0.003f, 0.02f}) {
    GltfWriter scene;
    const int matt = scene.add_material({});
    scene.add_quad(matt, {0, 0, 0}, {0, 1, 0}, {8, 8});
    scene.add_quad(matt, {0, -1000, 0}, {0, 1, 0}, {1, 1});
    scene.add_light({.type = "directional", .intensity = 3.0f, .direction = {-slope, -1, 0.7f * slope}});
    RenderRequest view = request(kStatic);
    view.look_at = LookAt{.eye = {3.0f, 2.5f, 4.0f}, .vertical_fov_deg = 40.0f};
    const auto share = shadow_of(scene.load(), view);
    EXPECT_GT(*std::min_element(share.begin(), share.end()), 0.999f) << slope;
  }
}

// The map stands still in the world, so that what moves is the viewer alone.
TEST(FarShadow, EdgesStayWhereTheyAreWhenTheViewerMoves) {
  constexpr std::uint32_t kShift = 13;
  constexpr float kHalf = 0.8f, kPixel = 2.0f * kHalf / kSize;
  const auto seen_from = [&](float z, const std::string& options) {
    GltfWriter scene;
    const int matt = scene.add_material({});
    scene.add_quad(matt, {0, 0, 0}, {0, 1, 0}, {20, 20});
    for (int i = -3; i <= 3; ++i)
      scene.add_box(matt, {0.3f * static_cast<float>(i), 0.1f, 0.37f * static_cast<float>(i)}, {0.15f, 0.2f, 0.1f});
    scene.add_light({.type = "directional", .intensity = 10.0f, .direction = {-0.5f, -1, 0.3f}});
    scene.add_orthographic_camera({0, 30, z}, {0, 0, z}, kHalf, 100.0f);
    return shadow_of(scene.load(), request(options));
  };
  for (const auto& kind : {kVsm + "far_shadows.size=2048", kStatic + "far_shadows.static_size=4096"}) {
    const auto before = seen_from(0.0f, kind), after = seen_from(kPixel * kShift, kind);
    std::uint32_t shadowed = 0, changed = 0;
    for (std::uint32_t y = 0; y < kSize; ++y)
      for (std::uint32_t x = kShift; x < kSize; ++x) {
        const float was = before[y * kSize + x], is = after[y * kSize + x - kShift];
        shadowed += was < 0.5f ? 1 : 0;
        changed += std::abs(was - is) > 0.25f ? 1 : 0;
      }
    EXPECT_GT(shadowed, 50u) << kind;
    EXPECT_LE(changed, shadowed / 50) << kind;
  }
}

TEST(FarShadow, IsTheSameOnTransparentSurfaces) {
  for (const auto& kind : {kVsm, kStatic}) {
    const auto opaque = shadow_of(Roof{}.load(), request(kind));
    const auto blended = shadow_of(Roof{.alpha_mode = "BLEND"}.load(), request(kind));
    double difference = 0.0, dark = 0.0;
    for (std::size_t i = 0; i < opaque.size(); ++i) {
      difference += static_cast<double>(std::abs(opaque[i] - blended[i]));
      dark += 1.0 - static_cast<double>(opaque[i]);
    }
    EXPECT_GT(dark, 100.0) << kind;
    // Opaque floors are in the map, and moments at the roof's edge mixed of both.
    EXPECT_LT(difference, 0.04 * dark) << kind;
  }
}

// Where the cascades hold all that can be seen, there is no map, and no pass that draws one.
TEST(FarShadow, CostsNothingWhereCascadesReach) {
  const Scene roof = Roof{}.load();
  for (const char* options : {"", "sun_shadows.cascades=1", "sun_shadows.distance=1000", "sun_shadows.enabled=off"}) {
    RenderRequest view = request(options);
    const auto result = engine().render(roof, view);
    EXPECT_EQ(passes_named(result.report, "far_shadows"), 0u) << options;
    RenderRequest off = view;
    off.settings.far_shadows.kind = FarShadow::off;
    EXPECT_EQ(largest_error(result.picture.linear, picture_of(roof, off).linear), 0.0) << options;
  }
}

// One cascade stays, for what moves; from two on, the last two go.
TEST(FarShadow, TheStaticMapReplacesTheLastTwoCascades) {
  const Scene roof = Roof{}.load();
  for (const char* cascades : {"1", "2", "4"}) {
    const std::string options =
        std::string(
            "sun_shadows.size=512 far_shadows.kind=static_map far_shadows.static_size=1024 sun_shadows.cascades=") +
        cascades;
    RenderRequest view = request(options);
    view.look_at = LookAt{.eye = {0, 1, 6}, .vertical_fov_deg = 10.0f};
    const bool whole = *cascades == '1';
    EXPECT_EQ(passes_named(engine().render(roof, view).report, "far_shadows"), whole ? 0u : 1u) << cascades;
    RenderRequest plain = view;
    plain.settings.far_shadows.kind = FarShadow::off;
    const auto with = shadow_of(roof, view), without = shadow_of(roof, plain);
    double changed = 0.0;
    for (std::size_t i = 0; i < with.size(); ++i) changed += static_cast<double>(std::abs(with[i] - without[i]));
    EXPECT_LT(changed, 0.02 * static_cast<double>(with.size())) << cascades;
  }
}

// Where all casters move there is nothing to put into a static map: the cascades stay.
TEST(FarShadow, WhatMovesIsInNoStaticMap) {
  for (const char* file : {"skinned_bar.gltf", "morph_cube.gltf"}) {
    const Scene moving = Scene::load(std::filesystem::path(VELARIUM_TEST_DATA) / file);
    RenderRequest view = request("far_shadows.kind=static_map");
    view.sun = Sun{};
    const auto result = engine().render(moving, view);
    EXPECT_EQ(passes_named(result.report, "sun_shadows"), 1u) << file;
    EXPECT_EQ(passes_named(result.report, "far_shadows"), 0u) << file;
    view.settings.far_shadows.kind = FarShadow::vsm;
    EXPECT_EQ(largest_error(result.picture.linear, picture_of(moving, view).linear), 0.0) << file;
  }
}

// The same where cascades end before the scene does.
TEST(FarShadow, BeyondShortCascadesWhatMovesThrowsNoShadow) {
  const Scene moving = Scene::load(std::filesystem::path(VELARIUM_TEST_DATA) / "skinned_bar.gltf");
  for (const char* update : {"all", "staggered"}) {
    Engine fresh(validated());
    RenderRequest view = request(kStatic + "sun_shadows.update=" + update),
                  without = request(kBeyond + "far_shadows.kind=off");
    view.sun = without.sun = Sun{};
    const auto result = fresh.render(moving, view);
    EXPECT_EQ(passes_named(result.report, "sun_shadows"), 1u) << update;
    EXPECT_EQ(passes_named(result.report, "far_shadows"), 0u) << update;
    EXPECT_TRUE(is_finite(result.picture)) << update;
    EXPECT_EQ(largest_error(result.picture.linear, picture_of(moving, without).linear), 0.0) << update;
  }
}

// In a loop that keeps maps it is drawn once, and again when the sun has moved. Else every picture draws its own.
TEST(FarShadow, TheStaticMapIsDrawnOnceForOneSun) {
  const Scene roof = Roof{}.load(), noon = Roof{.slope = 0.1f}.load();
  Engine keeping(validated());
  const auto view = request(kStatic + kStaggered);
  const auto first = keeping.render(roof, view), second = keeping.render(roof, view);
  EXPECT_EQ(passes_named(first.report, "far_shadows"), 1u);
  EXPECT_EQ(passes_named(second.report, "far_shadows"), 0u);
  EXPECT_EQ(largest_error(second.picture.linear, first.picture.linear), 0.0);
  // A view that needs no such map between two that do.
  EXPECT_EQ(passes_named(keeping.render(roof, request(kStaggered)).report, "far_shadows"), 0u);
  EXPECT_EQ(passes_named(keeping.render(roof, view).report, "far_shadows"), 0u);
  RenderRequest turned = view;
  turned.sun = Sun{.azimuth_deg = 30.0f, .elevation_deg = 40.0f, .illuminance_lux = 9.0f};
  const auto third = keeping.render(roof, turned);
  EXPECT_EQ(passes_named(third.report, "far_shadows"), 1u);
  EXPECT_EQ(largest_error(third.picture.linear, picture_of(roof, turned).linear), 0.0);
  EXPECT_EQ(passes_named(keeping.render(noon, view).report, "far_shadows"), 1u);
  const auto stateless = request(kStatic);
  for (int i = 0; i < 2; ++i) EXPECT_EQ(passes_named(keeping.render(roof, stateless).report, "far_shadows"), 1u);
}

TEST(FarShadow, TheMapOfMomentsIsDrawnForEveryEighthPicture) {
  const Scene roof = Roof{}.load();
  Engine keeping(validated());
  const auto view = request(kVsm + kStaggered);
  const auto first = keeping.render(roof, view);
  for (int picture = 0; picture < 17; ++picture) {
    const auto result = picture == 0 ? first : keeping.render(roof, view);
    EXPECT_EQ(passes_named(result.report, "far_shadows"), picture % 8 == 0 ? 1u : 0u) << picture;
    EXPECT_EQ(largest_error(result.picture.linear, first.picture.linear), 0.0) << picture;
  }
}

// Kept maps are those of a scene: another one may have the same sun, the same bounds and as many casters.
TEST(FarShadow, KeptMapsAreNotThoseOfAnotherScene) {
  for (const auto& options : {kStatic, kVsm, std::string("sun_shadows.size=256 sun_shadows.cascades=6 ")}) {
    Engine keeping(validated());
    const auto view = request(options + kStaggered);
    for (const float z : {0.0f, 1.0f, -1.0f}) {
      const Scene roof = Roof{.z = z}.load();
      Engine fresh(validated());
      EXPECT_EQ(largest_error(keeping.picture(roof, view).linear, fresh.picture(roof, view).linear), 0.0)
          << options << z;
    }
  }
}

// The memory of the map counts, and goes when the map does.
TEST(FarShadow, ItsMemoryIsReported) {
  const Scene roof = Roof{}.load();
  Engine fresh(validated());
  const auto without = fresh.render(roof, request(kBeyond + "far_shadows.kind=off")).report.device_bytes;
  const auto with = fresh.render(roof, request(kStatic + "far_shadows.static_size=4096")).report.device_bytes;
  EXPECT_GE(with, without + (std::uint64_t{32} << 20));
}

TEST(FarShadow, NoSceneNoMap) {
  GltfWriter empty;
  empty.add_light({.type = "directional", .intensity = 3.0f, .direction = {0, -1, 0}});
  empty.add_orthographic_camera({0, 1, 0}, {0, 0, 0}, 1.0f, 10.0f);
  const Scene nothing = empty.load();
  for (const auto& kind : {kVsm, kStatic})
    EXPECT_EQ(passes_named(engine().render(nothing, request(kind)).report, "far_shadows"), 0u);
}

TEST(FarShadow, DeclaresWhatItReads) {
  const Scene roof = Roof{}.load();
  for (const auto& kind : {kVsm, kStatic})
    EXPECT_EQ(largest_error(picture_of(roof, request(kind)).linear,
                            picture_of(roof, request(kind + "frame.sync=paranoid")).linear),
              0.0)
        << kind;
}

}  // namespace
}  // namespace velarium::test
