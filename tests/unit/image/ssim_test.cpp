#include "metric_pictures.hpp"

#include "image/ssim.hpp"

#include <algorithm>
#include <numeric>

namespace velarium::image {
namespace {

TEST(Ssim, EqualPicturesAreExactlyOne) {
  for (const float value : ssim(pattern(), pattern())) EXPECT_EQ(value, 1.0f);
}

TEST(Ssim, IsSymmetric) {
  EXPECT_EQ(ssim(pattern(), changed_pattern()), ssim(changed_pattern(), pattern()));
}

TEST(Ssim, OfUniformPicturesOnlyTheMeansDiffer) {
  // (2 p q + C1) / (p^2 + q^2 + C1) with C1 = 0.0001
  const double expected = (2 * 0.5 * 0.6 + 1e-4) / (0.25 + 0.36 + 1e-4);
  for (const float value : ssim(grey(0.5f), grey(0.6f))) EXPECT_NEAR(value, expected, 1e-5);
}

TEST(Ssim, OppositeStructureIsNegative) {
  const FloatImage stripes = picture_of([](std::uint32_t x, std::uint32_t) {
    return std::array<std::uint32_t, 3>{x % 2 * 255, x % 2 * 255, x % 2 * 255};
  });
  const auto values = ssim(stripes, mapped(stripes, [](float value) { return 1.0f - value; }));
  EXPECT_LT(values[20 * kPatternWidth + 20], -0.9f);
}

TEST(Ssim, IsThatOfScikitImage) {
  // scikit-image 0.19.3: structural_similarity(channel_axis=-1, gaussian_weights=True, sigma=1.5,
  // use_sample_covariance=False, data_range=1)
  const std::vector<float> values = ssim(changed_pattern(), pattern());
  EXPECT_NEAR(mean(values, inside_for_ssim({}, kPatternWidth, kPatternHeight)), 0.8139760, 1e-5);
  EXPECT_NEAR(values[20 * kPatternWidth + 20], 0.9081734, 1e-5);
}

TEST(Ssim, WindowsInsideThePictureCount) {
  const Mask inside = inside_for_ssim({}, 16, 12);
  EXPECT_EQ(std::accumulate(inside.begin(), inside.end(), 0), 6 * 2);
  EXPECT_EQ(inside[5 * 16 + 5], 1);
  EXPECT_EQ(inside[5 * 16 + 4], 0);
  EXPECT_TRUE(inside_for_ssim({}, 10, 40).empty());  // too small: every pixel counts
  Mask corner(16 * 12, 0);
  corner[0] = 1;
  EXPECT_EQ(inside_for_ssim(corner, 16, 12), corner);
}

}  // namespace
}  // namespace velarium::image
