#include "image/codecs.hpp"

#include "core/files.hpp"
#include "core/log.hpp"
#include "image/srgb.hpp"

#include <cmath>

namespace velarium::image {
namespace {

// No format stores more than 16 bytes a pixel uncompressed; the rest is room for headers and metadata.
std::uint64_t largest_file(const Limits& limits) {
  return 16 * limits.pixels + (64u << 20);
}

template <class Channel>
FloatImage linear_image(std::uint32_t width, std::uint32_t height, const std::vector<Channel>& rgba) {
  constexpr std::size_t kValues = std::size_t{1} << (8 * sizeof(Channel));
  constexpr auto kLargest = static_cast<float>(kValues - 1);
  std::vector<float> table(kValues);
  for (std::size_t i = 0; i < kValues; ++i) table[i] = linear_from_srgb(static_cast<float>(i) / kLargest);

  FloatImage image{width, height, std::vector<float>(rgba.size())};
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    const bool alpha = i % 4 == 3;
    image.rgba[i] = alpha ? static_cast<float>(rgba[i]) / kLargest : table[rgba[i]];
  }
  return image;
}

std::string pixel_text(const FloatImage& image, std::size_t value_index) {
  const std::size_t pixel = value_index / 4;
  return fmt::format("pixel ({}, {}) has the value {}", pixel % image.width, pixel / image.width,
                     image.rgba[value_index]);
}

void make_radiance(FloatImage& image, const std::string& what) {
  std::size_t negative = 0;
  std::string first;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    float& value = image.rgba[i];
    if (!std::isfinite(value)) invalid(what, pixel_text(image, i) + "; radiance is finite");
    if (value >= 0.0f) continue;
    if (negative++ == 0) first = pixel_text(image, i);
    value = 0.0f;
  }
  if (negative > 0) log_warning("{}: {}; such negative values ({} in all) are read as 0", what, first, negative);
}

FloatImage read_high_range(Bytes data, Format format, const std::string& what, const Limits& limits) {
  return format == Format::exr ? read_exr(data, what, limits) : read_hdr(data, what, limits);
}

}  // namespace

FloatImage load_radiance(const std::filesystem::path& file, const Limits& limits) {
  const std::vector<std::byte> data = read_file(file, largest_file(limits));
  const Format format = format_of(data);
  if (format != Format::exr && format != Format::hdr) {
    invalid(file.string(), data.empty() ? "is empty" : "is not an OpenEXR or Radiance (.hdr) picture");
  }
  FloatImage image = read_high_range(data, format, file.string(), limits);
  make_radiance(image, file.string());
  return image;
}

FloatImage load_linear(const std::filesystem::path& file, const Limits& limits) {
  const std::vector<std::byte> data = read_file(file, largest_file(limits));
  const Format format = format_of(data);
  if (format == Format::exr || format == Format::hdr) return read_high_range(data, format, file.string(), limits);
  if (format == Format::png) {
    check_size(png_size(data, file.string()), file.string(), limits);
    if (png_has_16_bits(data)) {
      const WordImage image = read_png_16(data, file.string(), limits);
      return linear_image(image.width, image.height, image.rgba);
    }
  }
  const ByteImage image = decode(data, file.string(), limits);
  return linear_image(image.width, image.height, image.rgba);
}

}  // namespace velarium::image
