#pragma once

#include <velarium/picture.hpp>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace velarium {

// How far a picture is from a reference, in one number.
enum class Metric {
  flip,    // mean perceived difference, 0 to 1 (Andersson et al. 2020; of linear light HDR-FLIP, 2021)
  psnr,    // peak signal-to-noise ratio with peak 1, decibels; infinite for equal pictures
  rmse,    // root of the mean squared difference
  relmse,  // mean of the squared difference over the squared reference plus 0.01; not symmetric
  ssim,    // mean structural similarity of display values, at most 1 (Wang et al. 2004)
  share,   // of the pixels with a channel that differs by more than CompareOptions::tolerance, 0 to 1
};

struct MetricInfo {
  Metric metric;
  std::string_view name;   // "flip"
  std::string_view title;  // "FLIP"
  std::string_view unit;   // "dB", or empty
  bool larger_is_better;
  double best;  // of equal pictures
  std::string_view help;
};

// In the order of the enumeration.
[[nodiscard]] std::span<const MetricInfo> metric_table();

struct PixelRegion {
  std::uint32_t x = 0, y = 0, width = 0, height = 0;  // width or height 0: the whole picture
};

struct CompareOptions {
  // Of the observer for FLIP. The papers' sits 0.7 m from a display that is 0.7 m and 3840 pixels wide.
  float pixels_per_degree = 67.02064f;  // from 1 to 1000
  float tolerance = 2.0f / 255.0f;      // of Metric::share, not negative: what rounding and dither to 8 bits may change
  bool as_display = false;              // compare display values even where both pictures hold linear light
  float exposure = 0.0f;  // stops by which linear light is multiplied where it is taken for display values
  PixelRegion crop;       // compared as if the pictures had been cut to it
  Picture mask;           // of the pictures' size: where it is lighter than half grey, pixels count; empty: all
  std::string name = "the picture", reference_name = "the reference";  // in errors and notes
};

// What comparing found. Places are relative to the crop.
struct Comparison {
  std::uint32_t width = 0, height = 0;  // of the compared region
  std::uint64_t pixels = 0;             // that the mask lets count
  bool linear = false;                  // linear light was compared, else display values
  double flip = 0.0, psnr_db = 0.0, rmse = 0.0, relmse = 0.0, ssim = 1.0, share = 0.0;
  double largest = 0.0;  // difference of a channel
  std::uint32_t largest_x = 0, largest_y = 0;
  float first_exposure = 0.0f, last_exposure = 0.0f;  // stops, of HDR-FLIP
  int exposures = 0;                                  // how many those are; 0 where display values were compared
  std::vector<float> flip_map;                        // one value a pixel, rows from the top, masked or not
  std::vector<std::string> notes;                     // what a user should hear of, one sentence each

  [[nodiscard]] double value(Metric metric) const;
  // Whether the picture is at least as good as the threshold.
  [[nodiscard]] bool within(Metric metric, double threshold) const;
};

// Linear light where both pictures hold it, display values where both hold those, and else display values of both,
// those of the linear one being its light times 2^exposure, clamped to 0..1 and sRGB-encoded.
//
// Pictures with transparent pixels: numbers are of four premultiplied channels; FLIP and SSIM look at the pictures over
// black and over white, and count the larger difference of each pixel.
//
// Throws Error(input_invalid) where sizes differ, a value is not finite (the error names picture and pixel), or the
// mask leaves nothing; Error(usage) where an option is out of range, or a picture holds no pixels.
[[nodiscard]] Comparison compare(const Picture& picture, const Picture& reference, const CompareOptions& options = {});

// A picture from a file: .png .jpg .webp as display values, .exr .hdr as linear light. `layer` names a part of an
// OpenEXR file, or those channels of its first part whose names begin with it and a dot; empty: the first part's own.
// Throws Error(input_missing, input_invalid, unsupported), and Error(usage) that lists the layers where there is no
// such.
[[nodiscard]] Picture load_picture(const std::filesystem::path& file, const std::string& layer = {});

// FLIP as a picture: colours from black (0) to pale yellow (1) as display values, the numbers as linear grey.
[[nodiscard]] Picture error_picture(const Comparison& comparison);

// A page of HTML that needs no other file and no network: both pictures under a slider, the error map, the numbers.
// `metric` and `threshold` are what decides. Arguments as those of the comparison.
[[nodiscard]] std::string comparison_page(const Picture& picture, const Picture& reference,
                                          const Comparison& comparison, const CompareOptions& options, Metric metric,
                                          double threshold);

}  // namespace velarium
