#pragma once

// One reader and writer a format, between bytes in memory and pixels. `what` names the data in errors.
// Readers check the header against the limits before they allocate pixels. Writers throw Error(output_not_written)
// where the format cannot hold the picture.

#include "image/image.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

namespace velarium::image {

using Bytes = std::span<const std::byte>;

enum class Format { unknown, png, jpeg, webp, exr, hdr };
[[nodiscard]] Format format_of(Bytes data);

[[noreturn]] inline void invalid(const std::string& what, const std::string& reason) {
  throw Error(ErrorCode::input_invalid, what, reason);
}

// Throws Error(input_invalid) where a header claims more than the limits, or nothing at all.
void check_size(Size size, const std::string& what, const Limits& limits);

[[nodiscard]] inline std::size_t channel_count(Size size) {
  return 4 * static_cast<std::size_t>(size.width) * size.height;
}

[[nodiscard]] Size png_size(Bytes data, const std::string& what);
[[nodiscard]] bool png_has_16_bits(Bytes data);  // precondition: png_size() has accepted the header
[[nodiscard]] ByteImage read_png(Bytes data, const std::string& what, const Limits& limits);
[[nodiscard]] WordImage read_png_16(Bytes data, const std::string& what, const Limits& limits);
[[nodiscard]] std::vector<std::byte> write_png(const ByteImage& image, const std::string& what,
                                               const Attributes& attributes = {});
[[nodiscard]] std::vector<std::byte> write_png(const WordImage& image, const std::string& what,
                                               const Attributes& attributes = {});

[[nodiscard]] Size jpeg_size(Bytes data, const std::string& what);
[[nodiscard]] ByteImage read_jpeg(Bytes data, const std::string& what, const Limits& limits);
[[nodiscard]] std::vector<std::byte> write_jpeg(const ByteImage& image, int quality, const std::string& what);

[[nodiscard]] Size webp_size(Bytes data, const std::string& what);
[[nodiscard]] ByteImage read_webp(Bytes data, const std::string& what, const Limits& limits);
[[nodiscard]] std::vector<std::byte> write_webp(const ByteImage& image, int quality, const std::string& what);

// Pixels as they are stored, or the light of a panorama that they mean: in BT.709's primaries, cubes unfolded.
enum class ExrMeaning { pixels, panorama };

// `layer` as load_picture() takes it.
[[nodiscard]] FloatImage read_exr(Bytes data, const std::string& what, const Limits& limits,
                                  const std::string& layer = {}, ExrMeaning meaning = ExrMeaning::pixels);
[[nodiscard]] std::vector<std::byte> write_exr(const FloatImage& image, bool half, const std::string& what);

[[nodiscard]] FloatImage read_hdr(Bytes data, const std::string& what, const Limits& limits);
[[nodiscard]] std::vector<std::byte> write_hdr(const FloatImage& image);

}  // namespace velarium::image
