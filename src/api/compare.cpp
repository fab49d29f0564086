#include <velarium/compare.hpp>

#include "api/compared_pictures.hpp"
#include "image/differences.hpp"
#include "image/error_colors.hpp"
#include "image/flip.hpp"
#include "image/ssim.hpp"

#include <velarium/error.hpp>
#include <velarium/options.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <variant>

namespace velarium {
namespace {

using compared::Pair;
using image::FloatImage;

constexpr std::array kMetrics{
    MetricInfo{Metric::flip, "flip", "FLIP", "", false, 0.0, "mean perceived difference, 0 to 1"},
    MetricInfo{Metric::psnr, "psnr", "PSNR", "dB", true, std::numeric_limits<double>::infinity(),
               "peak signal-to-noise ratio, peak 1"},
    MetricInfo{Metric::rmse, "rmse", "RMSE", "", false, 0.0, "root of the mean squared difference"},
    MetricInfo{Metric::relmse, "relmse", "relative MSE", "", false, 0.0,
               "mean of squared difference over squared reference"},
    MetricInfo{Metric::ssim, "ssim", "SSIM", "", true, 1.0, "mean structural similarity, 1 where equal"},
    MetricInfo{Metric::share, "share", "pixels off", "", false, 0.0,
               "share of pixels that differ by more than the tolerance"},
};

void check_range(float value, float least, float most, const char* name) {
  if (value >= least && value <= most) return;
  throw Error(ErrorCode::usage, fmt::format("{} is from {} to {}, not {}", name, least, most, value));
}

void check_options(const CompareOptions& options) {
  check_range(options.pixels_per_degree, 1.0f, 1000.0f, "the number of pixels per degree");
  if (!(options.tolerance >= 0.0f))
    throw Error(ErrorCode::usage, fmt::format("the tolerance is 0 or more, not {}", options.tolerance));
  const auto table = option_table();
  const auto row = std::find_if(table.begin(), table.end(), [](const auto& o) { return o.key == "display.exposure"; });
  check_range(options.exposure, static_cast<float>(row->minimum), static_cast<float>(row->maximum), "the exposure");
}

// One value a pixel, of pictures over one background.
struct Maps {
  std::vector<float> flip, ssim;
};

Maps maps_over(const Pair& pair, float background, const image::Exposures& exposures, const CompareOptions& options) {
  const FloatImage picture = compared::over(pair.picture, background);
  const FloatImage reference = compared::over(pair.reference, background);
  const float ppd = options.pixels_per_degree;
  if (!pair.linear) {
    return {image::flip(compared::linear_from_display(picture), compared::linear_from_display(reference), ppd),
            image::ssim(picture, reference)};
  }
  const auto display = [&](const FloatImage& light) { return compared::display_from_linear(light, options.exposure); };
  return {image::hdr_flip(picture, reference, exposures, ppd), image::ssim(display(picture), display(reference))};
}

// Whatever differs is seen over black or over white: over black colours are what they are premultiplied, and what
// white adds is known from alpha alone.
Maps maps_of(const Pair& pair, const image::Exposures& exposures, const CompareOptions& options) {
  Maps maps = maps_over(pair, 0.0f, exposures, options);
  if (image::is_opaque(pair.picture) && image::is_opaque(pair.reference)) return maps;
  const Maps white = maps_over(pair, 1.0f, exposures, options);
  for (std::size_t i = 0; i < maps.flip.size(); ++i) {
    maps.flip[i] = std::max(maps.flip[i], white.flip[i]);
    maps.ssim[i] = std::min(maps.ssim[i], white.ssim[i]);
  }
  return maps;
}

void set_differences(const image::Differences& found, Comparison& comparison) {
  comparison.pixels = found.pixels;
  comparison.rmse = found.rmse;
  comparison.psnr_db = found.psnr_db;
  comparison.relmse = found.relative_mse;
  comparison.share = found.share;
  comparison.largest = found.largest;
  comparison.largest_x = found.x;
  comparison.largest_y = found.y;
}

struct PictureOf {
  Picture operator()(image::WordImage image) const { return {image.width, image.height, {}, std::move(image.rgba)}; }
  Picture operator()(FloatImage image) const { return {image.width, image.height, std::move(image.rgba), {}}; }
};

}  // namespace

std::span<const MetricInfo> metric_table() {
  return kMetrics;
}

double Comparison::value(Metric metric) const {
  switch (metric) {
    case Metric::flip:
      return flip;
    case Metric::psnr:
      return psnr_db;
    case Metric::rmse:
      return rmse;
    case Metric::relmse:
      return relmse;
    case Metric::ssim:
      return ssim;
    case Metric::share:
      return share;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

bool Comparison::within(Metric metric, double threshold) const {
  const bool larger_is_better = kMetrics[static_cast<std::size_t>(metric)].larger_is_better;
  return larger_is_better ? value(metric) >= threshold : value(metric) <= threshold;
}

Comparison compare(const Picture& picture, const Picture& reference, const CompareOptions& options) {
  check_options(options);
  Pair pair = compared::pair_of(picture, reference, options);
  const image::Mask mask = compared::mask_of(picture, options);

  Comparison comparison;
  comparison.width = pair.picture.width;
  comparison.height = pair.picture.height;
  comparison.linear = pair.linear;
  set_differences(image::differences(pair.picture, pair.reference, mask, options.tolerance), comparison);
  const image::Exposures exposures = pair.linear ? image::exposures_of(pair.reference) : image::Exposures{.count = 0};
  comparison.first_exposure = exposures.first;
  comparison.last_exposure = exposures.last;
  comparison.exposures = exposures.count;
  Maps maps = maps_of(pair, exposures, options);
  comparison.flip = image::mean(maps.flip, mask);
  comparison.ssim = image::mean(maps.ssim, image::inside_for_ssim(mask, comparison.width, comparison.height));
  comparison.flip_map = std::move(maps.flip);
  comparison.notes = std::move(pair.notes);
  return comparison;
}

Picture load_picture(const std::filesystem::path& file, const std::string& layer) {
  return std::visit(PictureOf{}, image::load_picture(file, layer));
}

Picture error_picture(const Comparison& comparison) {
  constexpr std::uint16_t kStep = 257, kOpaque = 65535;  // 8-bit values widened to 16, as Picture::display holds them
  Picture picture{comparison.width, comparison.height, {}, {}};
  for (const float error : comparison.flip_map) {
    const auto color = image::error_color(error);
    picture.linear.insert(picture.linear.end(), {error, error, error, 1.0f});
    for (const std::uint16_t channel : color) picture.display.push_back(static_cast<std::uint16_t>(kStep * channel));
    picture.display.push_back(kOpaque);
  }
  return picture;
}

}  // namespace velarium
