#include "helpers.hpp"

#include <cmath>
#include <limits>

namespace velarium::image {
namespace {

using Hdr = InFolder;

const std::string kHeader = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

std::vector<float> colors(const FloatImage& image) {
  std::vector<float> rgb;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    if (i % 4 != 3) rgb.push_back(image.rgba[i]);
  }
  return rgb;
}

// Mantissa 128 with exponent 129 is 128 / 256 * 2^(129 - 128) = 1.
const std::string kOne = "\x80\x80\x80\x81";

TEST_F(Hdr, FlatPixels) {
  const FloatImage image =
      load_radiance(put("a.hdr", kHeader + "-Y 1 +X 2\n" + kOne + std::string("\x40\x80\xff\x80", 4)));
  EXPECT_EQ(colors(image), (std::vector<float>{1, 1, 1, 0.25f, 0.5f, 255.0f / 256.0f}));
  EXPECT_EQ(image.rgba[3], 1.0f);
}

TEST_F(Hdr, TheOlderRunsRepeatAndShift) {
  // Runs of 3 and then 1 << 8 pixels after the first: 260 in all.
  const std::string runs = kOne + std::string("\1\1\1\3\1\1\1\1", 8);
  const FloatImage image = load_radiance(put("a.hdr", kHeader + "-Y 1 +X 260\n" + runs));
  EXPECT_EQ(colors(image), std::vector<float>(780, 1.0f));
}

TEST_F(Hdr, TheNewerRunsAreByComponent) {
  const std::string line =
      std::string("\2\2\0\10", 4) + "\x88\x80" + "\x88\x40" + std::string("\10\0\1\2\3\4\5\6\7", 9) + "\x88\x81";
  const FloatImage image = load_radiance(put("a.hdr", kHeader + "-Y 1 +X 8\n" + line));
  for (std::size_t x = 0; x < 8; ++x) {
    EXPECT_EQ(image.rgba[4 * x], 1.0f);
    EXPECT_EQ(image.rgba[4 * x + 1], 0.5f);
    EXPECT_EQ(image.rgba[4 * x + 2], static_cast<float>(x) / 128.0f);
  }
}

TEST_F(Hdr, ExposuresMultiplyAndAreUndone) {
  const std::string header =
      "#?RGBE\n# a comment = 3\nEXPOSURE=2\nEXPOSURE= 4.0\nSOFTWARE=x\nFORMAT=32-bit_rle_rgbe\n\n";
  EXPECT_EQ(colors(load_radiance(put("a.hdr", header + "-Y 1 +X 1\n" + kOne))), std::vector<float>(3, 0.125f));
}

TEST_F(Hdr, ColourCorrectionsMultiplyAndAreUndone) {
  const std::string header = "#?RADIANCE\nCOLORCORR=2 4 1\nCOLORCORR= 1 1 0.5\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n";
  EXPECT_EQ(colors(load_radiance(put("a.hdr", header + kOne))), (std::vector<float>{0.5f, 0.25f, 2.0f}));
  for (const char* wrong : {"2", "2 2", "2 2 2 2", "0 1 1", "a b c"})
    expect_refused(ErrorCode::input_invalid, [&] {
      (void)load_radiance(put(
          "a.hdr", std::string("#?RADIANCE\nCOLORCORR=") + wrong + "\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + kOne));
    });
}

// Six pixels of red 1 to 6 (times 2^-8), as lines and pixels of each orientation bring them; rows from the top.
TEST_F(Hdr, AllEightOrientations) {
  std::string pixels;
  for (char value = 1; value <= 6; ++value) pixels += {value, 0, 0, static_cast<char>(128)};
  const std::pair<const char*, std::vector<float>> cases[] = {
      {"-Y 2 +X 3", {1, 2, 3, 4, 5, 6}}, {"-Y 2 -X 3", {3, 2, 1, 6, 5, 4}}, {"+Y 2 +X 3", {4, 5, 6, 1, 2, 3}},
      {"+Y 2 -X 3", {6, 5, 4, 3, 2, 1}}, {"+X 3 -Y 2", {1, 3, 5, 2, 4, 6}}, {"+X 3 +Y 2", {2, 4, 6, 1, 3, 5}},
      {"-X 3 -Y 2", {5, 3, 1, 6, 4, 2}}, {"-X 3 +Y 2", {6, 4, 2, 5, 3, 1}}};
  for (const auto& [resolution, wanted] : cases) {
    const FloatImage image = load_radiance(put("a.hdr", kHeader + resolution + "\n" + pixels));
    ASSERT_EQ(image.width, 3u);
    ASSERT_EQ(image.height, 2u);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(256.0f * image.rgba[4 * i], wanted[i]) << resolution << ' ' << i;
  }
}

// White of D65 and luminance 1, and the luminance of each primary (ITU-R BT.709).
TEST_F(Hdr, XyzBecomesRgb) {
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n";
  const auto byte = [](float value) { return static_cast<char>(std::lround(128.0f * value)); };
  const FloatImage white = load_radiance(
      put("a.hdr", header + std::string{byte(0.9505f), byte(1.0f), byte(1.0890f), static_cast<char>(129)}));
  for (const float value : colors(white)) EXPECT_NEAR(value, 1.0f, 0.03f);  // 7 bits
  const FloatImage red = load_radiance(
      put("a.hdr", header + std::string{byte(0.4124f), byte(0.2126f), byte(0.0193f), static_cast<char>(129)}));
  EXPECT_NEAR(red.rgba[0], 1.0f, 0.03f);
  EXPECT_NEAR(red.rgba[1], 0.0f, 0.03f);
  EXPECT_NEAR(red.rgba[2], 0.0f, 0.03f);
}

TEST_F(Hdr, OtherFormatsAreUnsupported) {
  expect_refused(ErrorCode::unsupported,
                 [&] { (void)load_radiance(put("a.hdr", "#?RADIANCE\nFORMAT=16-bit_planar\n\n-Y 1 +X 1\n" + kOne)); });
}

TEST_F(Hdr, BadHeadersAndRunsAreInvalid) {
  const std::string bad[] = {
      kHeader,
      kHeader + "-Y 1 +X\n" + kOne,
      kHeader + "-Y 1 +X 1 \n" + kOne,
      kHeader + "-Y 0 +X 1\n",
      kHeader + "-Y 99999999999 +X 1\n" + kOne,
      kHeader + "-Y 1000000 +X 1000000\n" + kOne,
      kHeader + "rubbish\n" + kOne,
      "#?RADIANCE\nEXPOSURE=0\n\n-Y 1 +X 1\n" + kOne,
      "#?RADIANCE\nEXPOSURE=nan\n\n-Y 1 +X 1\n" + kOne,
      kHeader + "-Y 1 +X 1\n\x80\x80\x80",
      kHeader + "-Y 1 +X 2\n" + std::string("\1\1\1\1", 4) + kOne,                      // a run with nothing before it
      kHeader + "-Y 1 +X 2\n" + kOne + std::string("\1\1\1\2", 4),                      // a run past the end
      kHeader + "-Y 1 +X 8\n" + std::string("\2\2\0\11", 4) + std::string(40, '\x88'),  // another width
      kHeader + "-Y 1 +X 8\n" + std::string("\2\2\0\10\x89\x80", 6),                    // nine of eight pixels
      kHeader + "-Y 1 +X 8\n" + std::string("\2\2\0\10\0", 5),                          // no progress
  };
  for (const std::string& file : bad) {
    expect_refused(ErrorCode::input_invalid, [&] { (void)load_radiance(put("a.hdr", file)); });
  }
}

TEST_F(Hdr, WhatIsSavedComesBackWithinHalfAStep) {
  for (const std::uint32_t width : {1u, 7u, 8u, 300u}) {
    FloatImage image = test_floats(width, 3);
    save_hdr(folder_ / "a.hdr", image);
    const FloatImage back = load_radiance(folder_ / "a.hdr");
    ASSERT_EQ(back.rgba.size(), image.rgba.size());
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
      // Half a step of 1/256 of a power of two that is at most twice the pixel's largest component.
      const float largest = std::max(image.rgba[i / 4 * 4], image.rgba[i / 4 * 4 + 1]);
      EXPECT_NEAR(back.rgba[i], image.rgba[i], i % 4 == 3 ? 0.0f : largest / 256.0f + 1e-30f);
    }
  }
}

TEST_F(Hdr, WhatTheFormatCannotHoldIsClamped) {
  const float huge = std::numeric_limits<float>::max(), nan = std::numeric_limits<float>::quiet_NaN();
  save_hdr(folder_ / "a.hdr", {2, 1, {huge, nan, -1.0f, 1.0f, 0.99999f, 1e-40f, 0.0f, 1.0f}});
  const FloatImage back = load_radiance(folder_ / "a.hdr");
  EXPECT_GT(back.rgba[0], 1e38f);
  EXPECT_EQ(back.rgba[1], 0.0f);
  EXPECT_EQ(back.rgba[2], 0.0f);
  EXPECT_EQ(back.rgba[4], 1.0f) << "rounding up moves to the next exponent";
}

TEST_F(Hdr, DamageIsRefused) {
  save_hdr(folder_ / "a.hdr", test_floats(64, 8));
  const std::string file = text_of(folder_ / "a.hdr");
  const auto read = [&](std::string_view data) { (void)load_radiance(put("b.hdr", data)); };
  expect_every_truncation_refused(file, read);
  expect_no_crash_on_damage(file, read);
}

TEST_F(Hdr, RealFilesAreRead) {
  const char* assets = std::getenv("VELARIUM_ASSETS");
  if (assets == nullptr) GTEST_SKIP() << "VELARIUM_ASSETS is not set";
  int read = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(assets) / "hdri")) {
    if (entry.path().extension() != ".hdr" && entry.path().extension() != ".exr") continue;
    const FloatImage image = load_radiance(entry.path());
    EXPECT_EQ(image.width, 2 * image.height) << entry.path();
    ++read;
  }
  EXPECT_GE(read, 4);
}

}  // namespace
}  // namespace velarium::image
