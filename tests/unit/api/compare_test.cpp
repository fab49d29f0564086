#include <velarium/compare.hpp>

#include <velarium/error.hpp>

#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace velarium {
namespace {

using Rgba = std::array<float, 4>;
using ColorAt = std::function<Rgba(std::uint32_t x, std::uint32_t y)>;

constexpr std::uint32_t kWidth = 24, kHeight = 16;

Picture light(const ColorAt& color_at) {
  Picture picture{kWidth, kHeight, {}, {}};
  for (std::uint32_t y = 0; y < kHeight; ++y)
    for (std::uint32_t x = 0; x < kWidth; ++x)
      for (const float value : color_at(x, y)) picture.linear.push_back(value);
  return picture;
}

Picture display(const ColorAt& color_at) {
  Picture picture = light(color_at);
  for (const float value : picture.linear)
    picture.display.push_back(static_cast<std::uint16_t>(std::lround(65535.0f * value)));
  picture.linear.clear();
  return picture;
}

ColorAt flat(float value, float alpha = 1.0f) {
  return [=](std::uint32_t, std::uint32_t) { return Rgba{value, value, value, alpha}; };
}

Rgba ramp(std::uint32_t x, std::uint32_t y) {
  return {static_cast<float>(x) / kWidth, static_cast<float>(y) / kHeight, 0.25f, 1.0f};
}

Rgba spotted_ramp(std::uint32_t x, std::uint32_t y) {
  return x == 5 && y == 3 ? Rgba{1, 1, 1, 1} : ramp(x, y);
}

// Of an Error, its code and text; fails where none is thrown.
void expect_error(ErrorCode code, const std::string& says, const Picture& picture, const Picture& reference,
                  const CompareOptions& options = {}) {
  try {
    (void)compare(picture, reference, options);
    ADD_FAILURE() << "nothing was thrown; expected " << says;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
  }
}

TEST(Compare, HalfAgainstSixTenthsIsTwentyDecibels) {
  for (const auto& made : {light, display}) {
    const Comparison found = compare(made(flat(0.5f)), made(flat(0.6f)));
    EXPECT_NEAR(found.psnr_db, 20.0, 1e-3);  // 16 bits hold no more digits
    EXPECT_NEAR(found.rmse, 0.1, 1e-5);
    EXPECT_EQ(found.share, 1.0);
    EXPECT_EQ(found.pixels, kWidth * kHeight);
  }
}

TEST(Compare, EqualPicturesHaveTheBestValueOfEachMetric) {
  for (const auto& made : {light, display}) {
    const Comparison found = compare(made(ramp), made(ramp));
    for (const MetricInfo& info : metric_table()) {
      EXPECT_EQ(found.value(info.metric), info.best) << info.name;
      EXPECT_TRUE(found.within(info.metric, info.best)) << info.name;
    }
    EXPECT_TRUE(found.notes.empty());
  }
}

TEST(Compare, AnyDifferenceIsBeyondTheBestValue) {
  for (const auto& made : {light, display}) {
    const Comparison found = compare(made(spotted_ramp), made(ramp));
    for (const MetricInfo& info : metric_table()) EXPECT_FALSE(found.within(info.metric, info.best)) << info.name;
    EXPECT_EQ(found.largest_x, 5u);
    EXPECT_EQ(found.largest_y, 3u);
  }
}

TEST(Compare, TheTableIsInTheOrderOfTheEnumeration) {
  for (std::size_t i = 0; i < metric_table().size(); ++i)
    EXPECT_EQ(static_cast<std::size_t>(metric_table()[i].metric), i);
}

TEST(Compare, BlackAgainstWhiteIsThePapersValue) {
  // See tests/unit/image/flip_test.cpp.
  EXPECT_NEAR(compare(display(flat(0)), display(flat(1))).flip, 0.9673798, 1e-5);
}

TEST(Compare, LinearLightIsLookedAtInSeveralExposures) {
  const auto wide = [](std::uint32_t x, std::uint32_t) {
    const float value = std::exp2(static_cast<float>(x) / 2.0f);
    return Rgba{value, value, value, 1};
  };
  const Comparison found = compare(light(wide), light(wide));
  EXPECT_TRUE(found.linear);
  EXPECT_EQ(found.exposures, 6);  // from 2^11.5 to the median between 2^5.5 and 2^6, one a stop
  EXPECT_EQ(compare(display(ramp), display(ramp)).exposures, 0);
}

TEST(Compare, OfTwoKindsDisplayValuesAreComparedAndThatIsSaid) {
  // The sRGB code of linear 0.5 is 0.735357 (IEC 61966-2-1).
  const Comparison found = compare(light(flat(0.5f)), display(flat(0.735357f)));
  EXPECT_FALSE(found.linear);
  EXPECT_LT(found.rmse, 1e-4);
  ASSERT_FALSE(found.notes.empty());
  EXPECT_NE(found.notes[0].find("the picture holds linear light"), std::string::npos) << found.notes[0];
  // One stop more.
  EXPECT_LT(compare(light(flat(0.25f)), display(flat(0.735357f)), {.exposure = 1.0f}).rmse, 1e-4);
}

TEST(Compare, DisplayValuesCanBeAskedFor) {
  const Comparison found = compare(light(flat(2.0f)), light(flat(3.0f)), {.as_display = true});
  EXPECT_FALSE(found.linear);
  EXPECT_EQ(found.rmse, 0.0);  // both are white
}

TEST(Compare, TransparencyIsADifference) {
  // A black that covers nothing shows over white alone.
  const Comparison found = compare(display(flat(0.0f, 0.0f)), display(flat(0.0f, 1.0f)));
  EXPECT_NEAR(found.flip, 0.9673798, 1e-5);
  EXPECT_LT(found.ssim, 0.01);
  EXPECT_NEAR(found.rmse, 0.5, 1e-6);  // one channel of four
  EXPECT_GT(compare(light(flat(0.0f, 0.0f)), light(flat(0.0f, 1.0f))).flip, 0.5);
}

TEST(Compare, ColoursThatNobodySeesAreNoDifference) {
  const Comparison found = compare(display(flat(0.2f, 0.0f)), display(flat(0.9f, 0.0f)));
  EXPECT_EQ(found.flip, 0.0);
  EXPECT_EQ(found.rmse, 0.0);
}

TEST(Compare, ACropIsAPictureOfItsOwn) {
  const Comparison with = compare(display(spotted_ramp), display(ramp), {.crop = {4, 2, 8, 6}});
  EXPECT_EQ(with.width, 8u);
  EXPECT_EQ(with.height, 6u);
  EXPECT_EQ(with.largest_x, 1u);
  EXPECT_EQ(with.largest_y, 1u);
  EXPECT_EQ(compare(display(spotted_ramp), display(ramp), {.crop = {6, 0, 18, 16}}).flip, 0.0);
  expect_error(ErrorCode::usage, "reaches beyond 24 x 16", display(ramp), display(ramp), {.crop = {20, 0, 5, 1}});
  expect_error(ErrorCode::usage, "reaches beyond", display(ramp), display(ramp), {.crop = {~0u, 0, 2, 1}});
}

TEST(Compare, AMaskChoosesPixels) {
  CompareOptions options;
  options.mask = display([](std::uint32_t x, std::uint32_t) { return flat(x < 12 ? 1.0f : 0.0f)(0, 0); });
  const auto half_changed = [](std::uint32_t x, std::uint32_t y) { return x < 12 ? ramp(x, y) : Rgba{1, 1, 1, 1}; };
  const Comparison found = compare(display(half_changed), display(ramp), options);
  EXPECT_EQ(found.rmse, 0.0);
  EXPECT_EQ(found.pixels, 12u * kHeight);
  EXPECT_EQ(found.flip_map.size(), kWidth * kHeight);
  EXPECT_LT(found.flip, compare(display(half_changed), display(ramp)).flip / 2);
  options.mask = display(flat(0.0f));
  expect_error(ErrorCode::input_invalid, "leaves no pixel", display(ramp), display(ramp), options);
  options.mask.width /= 2;
  options.mask.display.resize(options.mask.display.size() / 2);
  expect_error(ErrorCode::input_invalid, "the mask has 12 x 16", display(ramp), display(ramp), options);
}

TEST(Compare, NotANumberNamesPictureAndPixel) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
    const Picture broken = light([bad](std::uint32_t x, std::uint32_t y) {
      return x == 7 && y == 2 ? Rgba{0, bad, 0, 1} : ramp(x, y);
    });
    const CompareOptions options{.name = "a.exr", .reference_name = "b.exr"};
    expect_error(ErrorCode::input_invalid, "a.exr: pixel (7, 2)", broken, light(ramp), options);
    expect_error(ErrorCode::input_invalid, "b.exr: pixel (7, 2)", light(ramp), broken, options);
    expect_error(ErrorCode::input_invalid, "pixel (7, 2)", broken, display(ramp), {.crop = {6, 1, 4, 4}});
    expect_error(ErrorCode::input_invalid, "pixel (7, 2)", broken, broken, {.as_display = true});
  }
}

TEST(Compare, BlankPicturesAreSaid) {
  const Comparison found = compare(display(flat(0.5f)), display(ramp), {.name = "a.png"});
  ASSERT_EQ(found.notes.size(), 1u);
  EXPECT_EQ(found.notes[0], "a.png: every pixel has the same colour");
}

TEST(Compare, LightBelowZeroIsSaid) {
  const auto dips = [](std::uint32_t x, std::uint32_t y) { return x == 0 ? Rgba{-1, 0, 0, 1} : ramp(x, y); };
  const Comparison found = compare(light(dips), light(ramp));
  ASSERT_EQ(found.notes.size(), 1u);
  EXPECT_NE(found.notes[0].find("16 values are below 0"), std::string::npos) << found.notes[0];
}

TEST(Compare, OtherSizesAndNothingAreRefused) {
  Picture turned = display(ramp);
  std::swap(turned.width, turned.height);
  expect_error(ErrorCode::input_invalid, "has 16 x 24 pixels", turned, display(ramp));
  expect_error(ErrorCode::usage, "holds no pixels", {}, display(ramp));
  expect_error(ErrorCode::usage, "pixels per degree", display(ramp), display(ramp), {.pixels_per_degree = 0.0f});
  expect_error(ErrorCode::usage, "tolerance", display(ramp), display(ramp), {.tolerance = -1.0f});
  expect_error(ErrorCode::usage, "exposure", display(ramp), display(ramp), {.exposure = std::nanf("")});
}

TEST(Compare, FilesComeBackAsTheKindThatTheyAre) {
  const test::TemporaryFolder folder;
  const Picture shown = display(ramp), lit = light(ramp);
  Settings exact;
  exact.output.bits = 16;
  exact.output.exr = ExrType::full;
  shown.save(folder.path() / "a.png", exact);
  lit.save(folder.path() / "a.exr", exact);
  EXPECT_EQ(load_picture(folder.path() / "a.png").display, shown.display);
  EXPECT_EQ(load_picture(folder.path() / "a.exr").linear, lit.linear);
  EXPECT_TRUE(load_picture(folder.path() / "a.exr").display.empty());
  for (const char* lossy : {"a.jpg", "a.webp", "a.hdr"}) {
    Picture both = shown;
    both.linear = lit.linear;
    both.save(folder.path() / lossy);
    const Picture back = load_picture(folder.path() / lossy);
    EXPECT_GT(compare(back, both, {.as_display = back.linear.empty()}).psnr_db, 30.0) << lossy;
  }
}

TEST(ErrorPicture, HoldsColoursAndNumbers) {
  const Comparison found = compare(display(spotted_ramp), display(ramp));
  const Picture picture = error_picture(found);
  const std::size_t spot = 3 * kWidth + 5, far = 15 * kWidth + 23;
  EXPECT_EQ(picture.linear[4 * spot], found.flip_map[spot]);
  EXPECT_GT(found.flip_map[spot], 0.1f);
  EXPECT_GT(picture.display[4 * spot], picture.display[4 * far]);
  EXPECT_EQ(picture.display[4 * spot + 3], 65535);
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
  return count;
}

TEST(ComparisonPage, IsWholeAndNamesAreText) {
  const CompareOptions options{.name = "<b>&\"a\".png", .reference_name = "{{rows}}"};
  const Comparison found = compare(display(spotted_ramp), display(ramp), options);
  const std::string page = comparison_page(display(spotted_ramp), display(ramp), found, options, Metric::psnr, 99.0);
  EXPECT_EQ(page.find("<b>&"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;&amp;&quot;a&quot;.png"), std::string::npos);
  EXPECT_NE(page.find("beyond the threshold of 99&nbsp;dB"), std::string::npos);
  EXPECT_EQ(count_of(page, "data:image/png;base64,iVBORw0KGgo"), 3u);  // the first bytes of a PNG
  EXPECT_EQ(count_of(page, "src=\""), 3u);
  EXPECT_EQ(page.find("://"), std::string::npos);
  EXPECT_EQ(count_of(page, "{{"), count_of(page, "{{rows}}"));  // a name is no placeholder
}

}  // namespace
}  // namespace velarium
