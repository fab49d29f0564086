#include "driver_tolerance.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace velarium::test {
namespace {

constexpr Tolerance kUsual{.max_error = 3, .share = 0.25};

TEST(DriverTolerance, LavapipeKeepsTheUsualOne) {
  const Tolerance tolerance = tolerance_on("llvmpipe (LLVM 15.0.6, 256 bits)", "atrium", kUsual);
  EXPECT_EQ(tolerance.max_error, kUsual.max_error);
  EXPECT_EQ(tolerance.share, kUsual.share);
}

TEST(DriverTolerance, OtherDriversGetThatOfThePictureOrOfAll) {
  EXPECT_EQ(tolerance_on("SwiftShader Device (Subzero)", "atrium", kUsual).max_error, 16);
  EXPECT_EQ(tolerance_on("SwiftShader Device (Subzero)", "triangle", kUsual).max_error, 4);
}

TEST(DriverTolerance, EachIsOfAnAcceptedPictureAndSaysWhy) {
  for (const OtherDrivers& row : kOtherDrivers) {
    EXPECT_FALSE(row.why.empty()) << row.picture;
    const auto file = std::filesystem::path(VELARIUM_GOLDENS) / (std::string(row.picture) + ".png");
    EXPECT_TRUE(row.picture.empty() || std::filesystem::exists(file)) << file;
  }
  EXPECT_TRUE(std::rbegin(kOtherDrivers)->picture.empty());
}

}  // namespace
}  // namespace velarium::test
