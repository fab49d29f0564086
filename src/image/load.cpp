#include "image/codecs.hpp"

#include "core/files.hpp"
#include "core/foreign_files.hpp"
#include "core/log.hpp"
#include "image/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace velarium::image {
namespace {

// No format stores more than 16 bytes a pixel uncompressed; the rest is room for headers and metadata.
std::uint64_t largest_file(const Limits& limits) {
  return 16 * limits.pixels + (64u << 20);
}

FloatImage linear_image(const WordImage& image) {
  constexpr std::size_t kValues = 1u << 16;
  constexpr auto kLargest = static_cast<float>(kValues - 1);
  std::vector<float> table(kValues);
  for (std::size_t i = 0; i < kValues; ++i) table[i] = linear_from_srgb(static_cast<float>(i) / kLargest);

  FloatImage linear{image.width, image.height, std::vector<float>(image.rgba.size())};
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    const bool alpha = i % 4 == 3;
    linear.rgba[i] = alpha ? static_cast<float>(image.rgba[i]) / kLargest : table[image.rgba[i]];
  }
  return linear;
}

WordImage widened(const ByteImage& image) {
  constexpr std::uint16_t kStep = 65535 / 255;
  WordImage words{image.width, image.height, std::vector<std::uint16_t>(image.rgba.size())};
  std::transform(image.rgba.begin(), image.rgba.end(), words.rgba.begin(),
                 [](std::uint16_t value) { return static_cast<std::uint16_t>(kStep * value); });
  return words;
}

std::string pixel_text(const FloatImage& image, std::size_t value_index) {
  const std::size_t pixel = value_index / 4;
  return fmt::format("pixel ({}, {}) has the value {}", pixel % image.width, pixel / image.width,
                     image.rgba[value_index]);
}

// Makes radiance of values that are none, and tells of the first of each kind.
void make_radiance(FloatImage& image, const std::string& what) {
  constexpr float kLargestHalf = 65504.0f;
  struct Findings {
    std::size_t count = 0;
    std::string first;
  } not_finite, negative;
  const auto found = [&](Findings& findings, std::size_t i) {
    if (findings.count++ == 0) findings.first = pixel_text(image, i);
  };
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    float& value = image.rgba[i];
    if (value >= 0.0f && std::isfinite(value)) continue;
    found(std::isfinite(value) ? negative : not_finite, i);
    value = value > 0.0f ? kLargestHalf : 0.0f;
  }
  if (not_finite.count > 0)
    log_warning("{}: {}; such values ({} in all) are read as {}, NaN as 0", what, not_finite.first, not_finite.count,
                kLargestHalf);
  if (negative.count > 0)
    log_warning("{}: {}; such negative values ({} in all) are read as 0", what, negative.first, negative.count);
}

[[noreturn]] void not_a_picture(Bytes data, const std::string& what, std::string_view wanted) {
  if (data.empty()) invalid(what, "is empty");
  const std::string_view kind = foreign_kind(data);
  invalid(what, kind.empty() ? fmt::format("is not {} picture", wanted) : std::string(kind));
}

FloatImage panorama(const std::vector<std::byte>& data, const std::filesystem::path& file, const Limits& limits) {
  const std::string what = file.string();
  switch (format_of(data)) {
    case Format::exr:
      return read_exr(data, what, limits, {}, ExrMeaning::panorama);
    case Format::hdr:
      return read_hdr(data, what, limits);
    case Format::unknown:
      not_a_picture(data, what, "an OpenEXR or Radiance (.hdr)");
    default:
      break;
  }
  log_warning("{}: display values are taken as sRGB; nothing in it is brighter than 1 nit", what);
  return load_linear(file, limits);
}

}  // namespace

FloatImage load_radiance(const std::filesystem::path& file, const Limits& limits) {
  const std::vector<std::byte> data = read_file(file, largest_file(limits));
  const std::string what = file.string();
  FloatImage image = panorama(data, file, limits);
  make_radiance(image, what);
  return image;
}

AnyImage load_picture(const std::filesystem::path& file, const std::string& layer, const Limits& limits) {
  const std::vector<std::byte> data = read_file(file, largest_file(limits));
  const Format format = format_of(data);
  if (format == Format::unknown) not_a_picture(data, file.string(), "a PNG, JPEG, WebP, OpenEXR or Radiance (.hdr)");
  if (format == Format::exr) return read_exr(data, file.string(), limits, layer);
  if (!layer.empty())
    throw Error(ErrorCode::usage, file, fmt::format("has no layer '{}'; only OpenEXR files have layers", layer));
  if (format == Format::hdr) return read_hdr(data, file.string(), limits);
  if (format == Format::png) {
    check_size(png_size(data, file.string()), file.string(), limits);
    if (png_has_16_bits(data)) return read_png_16(data, file.string(), limits);
  }
  return widened(decode(data, file.string(), limits));
}

FloatImage load_linear(const std::filesystem::path& file, const Limits& limits) {
  AnyImage image = load_picture(file, {}, limits);
  if (auto* linear = std::get_if<FloatImage>(&image)) return std::move(*linear);
  return linear_image(std::get<WordImage>(image));
}

}  // namespace velarium::image
