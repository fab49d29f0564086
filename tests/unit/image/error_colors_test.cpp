#include "image/error_colors.hpp"
#include "image/opponent_color.hpp"
#include "image/srgb.hpp"

#include <gtest/gtest.h>

namespace velarium::image {
namespace {

float lightness_of(float error) {
  const auto color = error_color(error);
  const auto linear = [&](std::size_t c) { return linear_from_srgb(static_cast<float>(color[c]) / 255.0f); };
  return hunt_lab_from_rgb({linear(0), linear(1), linear(2)}).l;
}

TEST(ErrorColors, LightnessIsProportionalToTheError) {
  for (int i = 0; i <= 255; ++i) {
    const float error = static_cast<float>(i) / 255.0f;
    EXPECT_NEAR(lightness_of(error), 98.0f * error, 0.7f) << error;  // 8 bits hold no more digits of dark colours
  }
}

TEST(ErrorColors, ErrorsBeyondTheRangeHaveTheColoursOfItsEnds) {
  EXPECT_EQ(error_color(-1.0f), error_color(0.0f));
  EXPECT_EQ(error_color(2.0f), error_color(1.0f));
}

}  // namespace
}  // namespace velarium::image
