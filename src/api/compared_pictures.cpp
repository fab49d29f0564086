#include "api/compared_pictures.hpp"

#include "core/jobs.hpp"
#include "image/srgb.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace velarium::compared {
namespace {

using image::FloatImage;

constexpr float kLargestWord = 65535.0f;

std::size_t values_of(std::size_t width, std::size_t height) {
  return 4 * width * height;
}

bool holds_linear(const Picture& picture) {
  return picture.linear.size() == values_of(picture.width, picture.height);
}
bool holds_display(const Picture& picture) {
  return picture.display.size() == values_of(picture.width, picture.height);
}

void check_holds_pixels(const Picture& picture, const std::string& name) {
  const bool holds = holds_linear(picture) || holds_display(picture);
  if (picture.width == 0 || picture.height == 0 || !holds) throw Error(ErrorCode::usage, name, "holds no pixels");
}

PixelRegion region_of(const Picture& picture, const PixelRegion& crop) {
  if (crop.width == 0 || crop.height == 0) return {0, 0, picture.width, picture.height};
  const auto reaches = [](std::uint32_t start, std::uint32_t size) { return std::uint64_t{start} + size; };
  if (reaches(crop.x, crop.width) > picture.width || reaches(crop.y, crop.height) > picture.height) {
    throw Error(ErrorCode::usage, fmt::format("the crop {},{},{},{} reaches beyond {} x {} pixels", crop.x, crop.y,
                                              crop.width, crop.height, picture.width, picture.height));
  }
  return crop;
}

// A picture of the region's size, whose pixels `read` makes: it is given the index of the first value in the whole
// picture, and where the four go.
template <class Read>
FloatImage read_region(const Picture& picture, const PixelRegion& region, Read read) {
  FloatImage image{region.width, region.height, std::vector<float>(values_of(region.width, region.height))};
  parallel_for(region.height, [&](std::size_t y) {
    std::size_t from = values_of(picture.width, y + region.y) + values_of(region.x, 1);
    float* to = image.rgba.data() + values_of(region.width, y);
    for (std::uint32_t x = 0; x < region.width; ++x, from += 4, to += 4) read(from, to);
  });
  return image;
}

FloatImage display_values(const Picture& picture, const PixelRegion& region) {
  return read_region(picture, region, [&](std::size_t from, float* to) {
    const float alpha = static_cast<float>(picture.display[from + 3]) / kLargestWord;
    for (std::size_t c = 0; c < 3; ++c) to[c] = alpha * static_cast<float>(picture.display[from + c]) / kLargestWord;
    to[3] = alpha;
  });
}

void check_finite(const FloatImage& light, const PixelRegion& region, const std::string& name) {
  const auto bad =
      std::find_if(light.rgba.begin(), light.rgba.end(), [](float value) { return !std::isfinite(value); });
  if (bad == light.rgba.end()) return;
  const auto pixel = static_cast<std::size_t>(bad - light.rgba.begin()) / 4;
  throw Error(ErrorCode::input_invalid, name,
              fmt::format("pixel ({}, {}) has the value {}; only finite values can be compared",
                          region.x + pixel % light.width, region.y + pixel / light.width, *bad));
}

FloatImage linear_values(const Picture& picture, const PixelRegion& region, const std::string& name) {
  FloatImage light = read_region(picture, region, [&](std::size_t from, float* to) {
    std::copy_n(picture.linear.begin() + static_cast<std::ptrdiff_t>(from), 4, to);
  });
  check_finite(light, region, name);
  return light;
}

// A picture of which each pixel is made from the same pixel of another.
template <class Convert>
FloatImage converted(const FloatImage& image, Convert convert) {
  FloatImage result{image.width, image.height, std::vector<float>(image.rgba.size())};
  parallel_for(image.height, [&](std::size_t y) {
    for (std::size_t i = values_of(image.width, y); i < values_of(image.width, y + 1); i += 4)
      convert(image.rgba.data() + i, result.rgba.data() + i);
  });
  return result;
}

void note_if_blank(const FloatImage& image, const std::string& name, std::vector<std::string>& notes) {
  if (image.rgba.size() <= 4) return;
  for (std::size_t i = 4; i < image.rgba.size(); ++i)
    if (image.rgba[i] != image.rgba[i % 4]) return;
  notes.push_back(fmt::format("{}: every pixel has the same colour", name));
}

void note_if_negative(const FloatImage& image, const std::string& name, std::vector<std::string>& notes) {
  const auto count = std::count_if(image.rgba.begin(), image.rgba.end(), [](float value) { return value < 0.0f; });
  if (count > 0) notes.push_back(fmt::format("{}: {} values are below 0, which FLIP and SSIM see as 0", name, count));
}

}  // namespace

Pair pair_of(const Picture& picture, const Picture& reference, const CompareOptions& options) {
  check_holds_pixels(picture, options.name);
  check_holds_pixels(reference, options.reference_name);
  if (picture.width != reference.width || picture.height != reference.height) {
    throw Error(ErrorCode::input_invalid, options.name,
                fmt::format("has {} x {} pixels, {} has {} x {}; pictures of one size can be compared", picture.width,
                            picture.height, options.reference_name, reference.width, reference.height));
  }
  const PixelRegion region = region_of(picture, options.crop);
  Pair pair;
  pair.linear = !options.as_display && holds_linear(picture) && holds_linear(reference);
  const auto values = [&](const Picture& from, const std::string& name) {
    if (pair.linear) return linear_values(from, region, name);
    if (holds_display(from)) return display_values(from, region);
    if (!options.as_display) {
      pair.notes.push_back(
          fmt::format("{} holds linear light and the other display values: its light was clamped to "
                      "0..1 and sRGB-encoded, without a tone curve",
                      name));
    }
    return display_from_linear(linear_values(from, region, name), options.exposure);
  };
  pair.picture = values(picture, options.name);
  pair.reference = values(reference, options.reference_name);
  for (const auto note : {note_if_blank, note_if_negative}) {
    note(pair.picture, options.name, pair.notes);
    note(pair.reference, options.reference_name, pair.notes);
  }
  return pair;
}

image::Mask mask_of(const Picture& picture, const CompareOptions& options) {
  const Picture& mask = options.mask;
  if (mask.width == 0) return {};
  check_holds_pixels(mask, "the mask");
  if (mask.width != picture.width || mask.height != picture.height) {
    throw Error(ErrorCode::input_invalid, fmt::format("the mask has {} x {} pixels, the pictures {} x {}", mask.width,
                                                      mask.height, picture.width, picture.height));
  }
  const PixelRegion region = region_of(picture, options.crop);
  const FloatImage values =
      holds_display(mask) ? display_values(mask, region) : linear_values(mask, region, "the mask");
  image::Mask counts;
  counts.reserve(values.rgba.size() / 4);
  for (std::size_t i = 0; i < values.rgba.size(); i += 4)
    counts.push_back(values.rgba[i] + values.rgba[i + 1] + values.rgba[i + 2] > 1.5f ? 1 : 0);
  if (std::find(counts.begin(), counts.end(), 1) == counts.end())
    throw Error(ErrorCode::input_invalid, "the mask leaves no pixel to compare: those that are white count");
  return counts;
}

FloatImage over(const FloatImage& premultiplied, float background) {
  return converted(premultiplied, [background](const float* from, float* to) {
    for (std::size_t c = 0; c < 3; ++c) to[c] = from[c] + (1.0f - from[3]) * background;
    to[3] = 1.0f;
  });
}

FloatImage display_from_linear(const FloatImage& linear, float stops) {
  const float factor = std::exp2(stops);
  return converted(linear, [factor](const float* from, float* to) {
    const float alpha = std::clamp(from[3], 0.0f, 1.0f);
    for (std::size_t c = 0; c < 3; ++c) {
      const float straight = alpha > 0.0f ? from[c] / alpha : 0.0f;
      to[c] = alpha * image::srgb_from_linear(std::clamp(factor * straight, 0.0f, 1.0f));
    }
    to[3] = alpha;
  });
}

FloatImage linear_from_display(const FloatImage& display) {
  return converted(display, [](const float* from, float* to) {
    for (std::size_t c = 0; c < 3; ++c) to[c] = image::linear_from_srgb(from[c]);
    to[3] = from[3];
  });
}

image::ByteImage shown_bytes(const FloatImage& premultiplied, bool linear, float stops) {
  const FloatImage display = linear ? display_from_linear(premultiplied, stops) : premultiplied;
  image::ByteImage bytes{display.width, display.height, std::vector<std::uint8_t>(display.rgba.size())};
  for (std::size_t i = 0; i < display.rgba.size(); ++i) {
    const float alpha = display.rgba[i | 3];
    const float value = i % 4 == 3 || alpha == 0.0f ? display.rgba[i] : display.rgba[i] / alpha;
    bytes.rgba[i] = static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
  }
  return bytes;
}

}  // namespace velarium::compared
