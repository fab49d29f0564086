// shadows.memory: which maps get smaller, and that they fit. Numbers are texels times bytes, by hand.

#include "frame/shadow_memory.hpp"

#include <gtest/gtest.h>

#include <string>

namespace velarium::frame {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;

// Four maps of the sun of 2048^2 texels, 12 bytes each: 192 MiB. An atlas of 4096^2, 12 bytes: 192 MiB. A far map of
// 2048^2, 20 bytes while it is drawn: 80 MiB.
constexpr ShadowNeeds kAll{
    .sun_maps = 4, .sun_veils = true, .far = FarSun::vsm, .atlas = true, .atlas_veils = true, .mask_bytes = 0};

Settings settings_of(int memory) {
  Settings settings;
  settings.shadows.memory = memory;
  settings.sun_shadows.size = 2048;
  settings.sun_shadows.far_size = 2048;
  settings.sun_shadows.static_size = 8192;
  settings.local_shadows.atlas = 4096;
  return settings;
}

struct Sides {
  int far, atlas, sun;
  bool operator==(const Sides&) const = default;
};

void PrintTo(const Sides& sides, std::ostream* out) {
  *out << sides.far << ' ' << sides.atlas << ' ' << sides.sun;
}

Sides sides_of(const Settings& settings) {
  return {settings.sun_shadows.far_size, settings.local_shadows.atlas, settings.sun_shadows.size};
}

TEST(ShadowMemory, IsTexelsTimesBytes) {
  EXPECT_EQ(shadow_bytes(settings_of(1024), kAll), 464 * kMiB);
  EXPECT_EQ(shadow_bytes(settings_of(1024), {.sun_maps = 1}), 16 * kMiB);
  EXPECT_EQ(shadow_bytes(settings_of(1024), {.far = FarSun::static_map}), 128 * kMiB);
  EXPECT_EQ(shadow_bytes(settings_of(1024), {.atlas = true}), 64 * kMiB);
  EXPECT_EQ(shadow_bytes(settings_of(1024), {.mask_bytes = 5}), 5u);
  EXPECT_EQ(shadow_bytes(settings_of(1024), {}), 0u);
}

TEST(ShadowMemory, DefaultsFit) {
  const auto fitted = fit_to_budget(Settings(), {.sun_maps = 4,
                                                 .sun_veils = true,
                                                 .far = FarSun::static_map,
                                                 .atlas = true,
                                                 .atlas_veils = true,
                                                 .mask_bytes = std::uint64_t{4} * 3840 * 2160});
  EXPECT_EQ(fitted.note, "");
}

TEST(ShadowMemory, WhatFitsStays) {
  const auto fitted = fit_to_budget(settings_of(464), kAll);
  EXPECT_EQ(sides_of(fitted.settings), (Sides{2048, 4096, 2048}));
  EXPECT_EQ(fitted.note, "");
}

TEST(ShadowMemory, TheLargestAreHalvedInTurn) {
  // Atlas and sun take 192 each, the atlas is first: 80 + 48 + 192.
  EXPECT_EQ(sides_of(fit_to_budget(settings_of(463), kAll).settings), (Sides{2048, 2048, 2048}));
  // Then the sun: 80 + 48 + 48.
  EXPECT_EQ(sides_of(fit_to_budget(settings_of(256), kAll).settings), (Sides{2048, 2048, 1024}));
  // Then the far map and the atlas: 20 + 12 + 48.
  EXPECT_EQ(sides_of(fit_to_budget(settings_of(100), kAll).settings), (Sides{1024, 1024, 1024}));
}

// 8192^2 texels of two bytes and two maps of 4096^2 of four are 128 MiB each.
TEST(ShadowMemory, TheFarMapGoesBeforeItsEquals) {
  Settings settings = settings_of(255);
  settings.sun_shadows.size = 4096;
  const auto fitted = fit_to_budget(settings, {.sun_maps = 2, .far = FarSun::static_map}).settings;
  EXPECT_EQ(fitted.sun_shadows.static_size, 4096);
  EXPECT_EQ(fitted.sun_shadows.size, 4096);
}

TEST(ShadowMemory, TheNoteSaysWhatIsSmaller) {
  EXPECT_EQ(fit_to_budget(settings_of(256), kAll).note,
            "local_shadows.atlas is 2048 instead of 4096, sun_shadows.size is 1024 instead of 2048: "
            "shadows.memory=256 allows no more");
}

TEST(ShadowMemory, WhatIsNotNeededIsNotTouched) {
  const auto fitted = fit_to_budget(settings_of(8), {.sun_maps = 1}).settings;
  EXPECT_EQ(sides_of(fitted), (Sides{2048, 4096, 1024}));
  EXPECT_EQ(fitted.sun_shadows.static_size, 8192);
}

TEST(ShadowMemory, EveryBudgetIsKept) {
  ShadowNeeds needs = kAll;
  needs.sun_maps = 6;
  for (const int size : {16384, 10000, 300}) {
    Sides before{0, 0, 0};
    for (int memory = 8; memory < 40000; memory += 1 + memory / 3) {
      Settings settings = settings_of(memory);
      settings.sun_shadows.size = settings.local_shadows.atlas = size;
      settings.sun_shadows.far_size = size / 2;
      const auto fitted = fit_to_budget(settings, needs).settings;
      EXPECT_LE(shadow_bytes(fitted, needs), static_cast<std::uint64_t>(memory) * kMiB) << size << ' ' << memory;
      const Sides sides = sides_of(fitted);
      EXPECT_TRUE(sides.far >= before.far && sides.atlas >= before.atlas && sides.sun >= before.sun)
          << "more memory, smaller maps: " << size << ' ' << memory;
      before = sides;
    }
  }
}

// A mask of a picture of 32 megapixels alone takes more.
TEST(ShadowMemory, AMaskThatDoesNotFitIsSaid) {
  ShadowNeeds needs = kAll;
  needs.mask_bytes = 128 * kMiB;
  const auto fitted = fit_to_budget(settings_of(64), needs);
  EXPECT_EQ(sides_of(fitted.settings), (Sides{kLeastMapSide, kLeastMapSide, kLeastMapSide}));
  EXPECT_NE(fitted.note.find("more than shadows.memory=64"), std::string::npos) << fitted.note;
}

TEST(ShadowMemory, SmallMapsStay) {
  Settings settings = settings_of(8);
  settings.sun_shadows.size = 64;
  settings.local_shadows.atlas = 256;
  EXPECT_EQ(sides_of(fit_to_budget(settings, kAll).settings), (Sides{512, 256, 64}));  // 5 + 0.75 + 0.19 MiB
}

}  // namespace
}  // namespace velarium::frame
