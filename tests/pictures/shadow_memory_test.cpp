// What shadow maps take is reported, and shadows.memory bounds it.

#include "support/device.hpp"
#include "support/gltf_writer.hpp"
#include "support/metric.hpp"
#include "support/pictures.hpp"
#include "support/settings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <string>

namespace velarium::test {
namespace {

constexpr std::uint32_t kSize = 96;
constexpr double kMiB = 1 << 20;
// A map of the sun, the atlas with its veils: 12 MiB each; a far map, 20 MiB.
const std::string kMaps =
    "sun_shadows.size=1024 sun_shadows.cascades=1 sun_shadows.distance=2.5 far_shadows.size=1024 "
    "local_shadows.atlas=1024 ";
const std::string kNone = "sun_shadows.enabled=off local_shadows.enabled=off ";

// A floor, a body and a sheet under a sun and a light. The camera is three metres up: the map of the sun ends above the
// floor.
Scene lit_floor() {
  GltfWriter scene;
  scene.add_quad(scene.add_material({}), {0, 0, 0}, {0, 1, 0}, {6, 6});
  scene.add_box(scene.add_material({}), {0.5f, 1, 0.5f}, {0.4f, 0.4f, 0.4f});
  scene.add_quad(
      scene.add_material({.base_color = {0.8f, 0.2f, 0.1f, 0.5f}, .double_sided = true, .alpha_mode = "BLEND"}),
      {0.5f, 1, -0.5f}, {0, 1, 0}, {0.6f, 0.6f});
  scene.add_light({.type = "directional", .intensity = 3.0f, .direction = {-1, -1, 0}});
  scene.add_light({.type = "point", .intensity = 20.0f, .position = {2, 2, 0}});
  scene.add_orthographic_camera({0, 3, 0}, {0, 0, 0}, 1.5f, 10.0f);
  return scene.load();
}

RenderRequest request(const std::string& options) {
  RenderRequest request = linear_request(kSize, kSize);
  set_options(request.settings, kMaps + options);
  return request;
}

std::map<std::string, std::uint64_t> maps_of(const RenderReport& report) {
  std::map<std::string, std::uint64_t> maps;
  for (const auto& map : report.shadow_maps) maps[map.name] = map.bytes;
  return maps;
}

double total(const RenderReport& report) {
  return std::accumulate(report.shadow_maps.begin(), report.shadow_maps.end(), 0.0,
                         [](double sum, const auto& map) { return sum + static_cast<double>(map.bytes); });
}

double brightness(const Picture& picture) {
  return std::accumulate(picture.linear.begin(), picture.linear.end(), 0.0);
}

TEST(ShadowMemory, EveryMapIsReported) {
  const auto maps = maps_of(engine().render(lit_floor(), request("")).report);
  const std::map<std::string, double> texels{
      {"sun_shadows.cascades", 4 * kMiB},     {"sun_translucency.cascades", 8 * kMiB},
      {"far_shadows.map", 8 * kMiB},          {"far_shadows.depth", 4 * kMiB},
      {"local_shadows.atlas", 4 * kMiB},      {"local_translucency.atlas", 8 * kMiB},
      {"far_shadows_rows.moments", 8 * kMiB}, {"sun_shadow_mask.occlusion", 4.0 * kSize * kSize}};
  ASSERT_EQ(maps.size(), texels.size());
  for (const auto& [name, bytes] : texels) {
    ASSERT_TRUE(maps.contains(name)) << name;
    EXPECT_GE(static_cast<double>(maps.at(name)), bytes) << name;
    EXPECT_LE(static_cast<double>(maps.at(name)), 1.1 * bytes + 65536) << name;  // drivers align
  }
}

// Besides maps, shadows take but some buffers.
TEST(ShadowMemory, TheSumIsWhatTheDeviceGives) {
  const Scene scene = lit_floor();
  const auto shadowed = Engine(validated()).render(scene, request("")).report;
  const auto open = Engine(validated()).render(scene, request(kNone)).report;
  EXPECT_NEAR(static_cast<double>(shadowed.device_bytes) - static_cast<double>(open.device_bytes), total(shadowed),
              65536.0);
}

TEST(ShadowMemory, IsBounded) {
  const Scene scene = lit_floor();
  const auto full = engine().render(scene, request(""));
  const auto small = engine().render(scene, request("shadows.memory=16"));
  EXPECT_TRUE(full.report.notes.empty());
  // 5 of the far map, 3 of the atlas and 3 of the sun.
  ASSERT_EQ(small.report.notes.size(), 1u);
  EXPECT_EQ(small.report.notes.front(),
            "far_shadows.size is 512 instead of 1024, local_shadows.atlas is 512 instead of 1024, sun_shadows.size "
            "is 512 instead of 1024: shadows.memory=16 allows no more");
  EXPECT_GE(total(small.report), 11 * kMiB);
  EXPECT_LE(total(small.report), 16 * kMiB);
  // Shadows have other edges, and are where they were.
  const double open = brightness(picture_of(scene, request(kNone)));
  const double shadow = open - brightness(full.picture);
  EXPECT_GT(shadow, 0.01 * open);
  EXPECT_NEAR(brightness(small.picture), brightness(full.picture), 0.05 * shadow);
}

TEST(ShadowMemory, StaticMapsAreBounded) {
  const auto kind = request("far_shadows.kind=static_map far_shadows.static_size=4096 shadows.memory=40");
  const auto result = engine().render(lit_floor(), kind);
  ASSERT_EQ(result.report.notes.size(), 1u);
  EXPECT_EQ(result.report.notes.front(),
            "far_shadows.static_size is 2048 instead of 4096: shadows.memory=40 allows no more");
  EXPECT_LE(total(result.report), 40 * kMiB);
}

// What one picture needed is not held for the next.
TEST(ShadowMemory, GoesWithTheMaps) {
  const Scene scene = lit_floor();
  Engine fresh(validated());
  EXPECT_TRUE(fresh.render(scene, request(kNone)).report.shadow_maps.empty());
  EXPECT_TRUE(maps_of(fresh.render(scene, request("")).report).contains("far_shadows.depth"));
  const auto still = maps_of(fresh.render(scene, request("far_shadows.kind=static_map")).report);
  EXPECT_FALSE(still.contains("far_shadows.depth"));
  EXPECT_TRUE(still.contains("far_shadows.map"));
  EXPECT_TRUE(fresh.render(scene, request(kNone)).report.shadow_maps.empty());
}

}  // namespace
}  // namespace velarium::test
