#include "image/flip_filters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace velarium::image {
namespace {

using std::numbers::pi;

// Contrast sensitivity is a sum of a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees (FLIP, section 4.1, table 1).
struct Sensitivity {
  double a, b;
};
constexpr Sensitivity kLuminance{1.0, 0.0047}, kRedGreen{1.0, 0.0053};
constexpr Sensitivity kBlueYellowWide{34.1, 0.04}, kBlueYellowNarrow{13.5, 0.025};

// Human edge detection: the distance from peak to trough, in degrees, is two standard deviations (section 4.2).
constexpr double kFeatureWidth = 0.082;

// Both papers' Gaussians end after three standard deviations of the widest.
std::size_t radius_of(double sigma) {
  return static_cast<std::size_t>(std::ceil(3.0 * sigma));
}

// In pixels: exp(-pi^2 x^2 / b) is a Gaussian of variance b / (2 pi^2).
double sigma_of(const Sensitivity& s, double pixels_per_degree) {
  return std::sqrt(s.b / (2.0 * pi * pi)) * pixels_per_degree;
}

// The share of one Gaussian in the sum over all pixels, before that is normalised.
double weight_of(const Sensitivity& s, double sigma, std::size_t radius) {
  double sum = 0.0;
  for (std::size_t i = 0; i <= 2 * radius; ++i) {
    const double x = static_cast<double>(i) - static_cast<double>(radius);
    sum += std::exp(-x * x / (2.0 * sigma * sigma));
  }
  return s.a * std::sqrt(pi / s.b) * sum * sum;
}

Kernel scaled(Kernel kernel, double scale) {
  for (float& tap : kernel.taps) tap *= static_cast<float>(scale);
  return kernel;
}

// Weights above 0 sum to 1, those below to -1, so that features of a picture from 0 to 1 are from -1 to 1.
Kernel balanced(const std::vector<double>& weights) {
  double above = 0.0, below = 0.0;
  for (const double weight : weights) (weight > 0.0 ? above : below) += std::abs(weight);
  Kernel kernel;
  for (const double weight : weights) {
    const double sum = weight > 0.0 ? above : below;
    kernel.taps.push_back(sum > 0.0 ? static_cast<float>(weight / sum) : 0.0f);
  }
  return kernel;
}

// Where a Gaussian is narrower than the distance of pixels, its samples beside the middle one may be 0.
void add_feature_kernels(double pixels_per_degree, FlipFilters& filters) {
  const double sigma = 0.5 * kFeatureWidth * pixels_per_degree;
  const std::size_t radius = radius_of(sigma);
  filters.blur = gaussian(sigma, radius);
  std::vector<double> slope, curvature;
  for (std::size_t i = 0; i <= 2 * radius; ++i) {
    const double x = static_cast<double>(i) - static_cast<double>(radius);
    const double g = std::exp(-x * x / (2.0 * sigma * sigma));
    slope.push_back(-x * g);
    curvature.push_back((x * x / (sigma * sigma) - 1.0) * g);
  }
  filters.slope = balanced(slope);
  filters.curvature = balanced(curvature);
}

}  // namespace

std::size_t FlipFilters::padding() const {
  std::size_t padding = 0;
  for (const Kernel* kernel : {&luminance, &red_green, &wide_rows, &narrow_rows, &blur})
    padding = std::max(padding, kernel->radius());
  return padding;
}

FlipFilters flip_filters(float pixels_per_degree) {
  const double wide = sigma_of(kBlueYellowWide, pixels_per_degree);
  const double narrow = sigma_of(kBlueYellowNarrow, pixels_per_degree);
  const std::size_t radius = radius_of(wide);
  const double wide_weight = weight_of(kBlueYellowWide, wide, radius);
  const double narrow_weight = weight_of(kBlueYellowNarrow, narrow, radius);
  const double sum = wide_weight + narrow_weight;

  FlipFilters filters;
  filters.luminance = trimmed(gaussian(sigma_of(kLuminance, pixels_per_degree), radius));
  filters.red_green = trimmed(gaussian(sigma_of(kRedGreen, pixels_per_degree), radius));
  filters.wide_rows = gaussian(wide, radius);
  filters.wide_columns = scaled(filters.wide_rows, wide_weight / sum);
  filters.narrow_rows = gaussian(narrow, radius);
  filters.narrow_columns = scaled(filters.narrow_rows, narrow_weight / sum);
  add_feature_kernels(pixels_per_degree, filters);
  return filters;
}

}  // namespace velarium::image
