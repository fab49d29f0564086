#include "image/image.hpp"

#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <variant>

namespace velarium::image {
namespace {

class ExrParts : public testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "parts.exr";
};

TEST_F(ExrParts, AreReadBackByName) {
  const std::vector<float> beauty{1, 2, 3, 0.5f, 4, 5, 6, 1}, depth{0.1f, 1e6f};
  const std::vector<ExrPart> parts{{"beauty", {"R", "G", "B", "A"}, beauty, true}, {"depth", {"Z"}, depth, false}};
  save_exr_parts(file_, {2, 1}, parts, {{"velarium:finished", "no"}});
  const auto first = std::get<FloatImage>(load_picture(file_));
  EXPECT_EQ(first.width, 2u);
  EXPECT_EQ(first.height, 1u);
  EXPECT_EQ(first.rgba, beauty);
  const auto second = std::get<FloatImage>(load_picture(file_, "depth"));
  EXPECT_EQ(second.rgba, (std::vector<float>{0.1f, 0.1f, 0.1f, 1.0f, 1e6f, 1e6f, 1e6f, 1.0f}));
}

TEST_F(ExrParts, DirectionsAreReadAsColours) {
  const std::vector<ExrPart> parts{{"normal", {"X", "Y", "Z"}, {0.25f, -0.5f, 1.0f}, false}};
  save_exr_parts(file_, {1, 1}, parts);
  EXPECT_EQ(std::get<FloatImage>(load_picture(file_, "normal")).rgba, (std::vector<float>{0.25f, -0.5f, 1.0f, 1.0f}));
}

TEST_F(ExrParts, HalvesSaturate) {
  const std::vector<ExrPart> parts{{"beauty", {"R", "G", "B"}, {1e6f, -1e6f, 1.0f}, true}};
  save_exr_parts(file_, {1, 1}, parts);
  EXPECT_EQ(std::get<FloatImage>(load_picture(file_)).rgba, (std::vector<float>{65504.0f, -65504.0f, 1.0f, 1.0f}));
}

}  // namespace
}  // namespace velarium::image
