#pragma once

// Pixels in memory, and files of pixels. Rows from the top.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace velarium::image {

struct ByteImage {  // 8 bits a channel, RGBA, straight alpha, as stored
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

struct WordImage {  // 16 bits a channel, RGBA, straight alpha, native byte order
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint16_t> rgba;
};

struct FloatImage {  // linear; RGBA, alpha 1 where the file has none
  std::uint32_t width = 0, height = 0;
  std::vector<float> rgba;
};

struct Limits {  // checked against the header, before pixels are allocated
  std::uint64_t pixels = 1ull << 28;
  std::uint32_t size = 16384;  // width or height
};

// PNG (any type and depth, reduced to 8 bits), JPEG (grey, YCbCr, CMYK) or WebP, recognised by content.
// `what` names the data in errors (a file, a JSON pointer). Throws Error(input_invalid), Error(unsupported).
[[nodiscard]] ByteImage decode(std::span<const std::byte> data, const std::string& what, const Limits& limits = {});

// The size in pixels that the header claims, without decoding. Throws as decode().
struct Size {
  std::uint32_t width, height;
};
[[nodiscard]] Size peek_size(std::span<const std::byte> data, const std::string& what);

// A panorama of light: Radiance .hdr (flat, old and new run-length, in any orientation, RGB or XYZ) or OpenEXR (also a
// cube, which becomes a panorama, in other primaries, or of luminance and chroma), by content; PNG, JPEG and WebP as
// sRGB, with a warning. Values that are no radiance become one with a warning that names a pixel: infinity the largest
// half, 65504, NaN and negative ones, which resampling and lossy compression leave in real files, 0. Throws
// Error(input_missing), Error(input_invalid), Error(unsupported).
[[nodiscard]] FloatImage load_radiance(const std::filesystem::path& file, const Limits& limits = {});

// Any of the formats above as its file holds it: display values, 8 bits widened to 16 (n becomes 257 n), or linear
// light. `layer` names a part of an OpenEXR file, or those channels of its first part whose names begin with it and a
// dot; empty: those of the first part that has R, G and B, else of its only layer. Throws as decode() and
// load_radiance(), and Error(usage) where a layer is named that the file has not. Values need not be finite.
using AnyImage = std::variant<WordImage, FloatImage>;
[[nodiscard]] AnyImage load_picture(const std::filesystem::path& file, const std::string& layer = {},
                                    const Limits& limits = {});

// The same as linear floats: sRGB-encoded formats are decoded, alpha kept straight.
[[nodiscard]] FloatImage load_linear(const std::filesystem::path& file, const Limits& limits = {});

// What a file says about itself besides its pixels: names and texts.
using Attributes = std::vector<std::pair<std::string, std::string>>;

// One part of an OpenEXR file of several: pixels with channels of its own, interleaved.
struct ExrPart {
  std::string name;
  std::vector<std::string> channels;
  std::vector<float> values;
  bool half = false;  // store 16-bit floats: values beyond 65504 become that
};

// All writers make the file whole or not at all (a temporary name in the same folder, then a rename)
// and throw Error(output_not_written) with the system's reason.
void save_png(const std::filesystem::path& file, const ByteImage& image, const Attributes& attributes = {});
void save_png(const std::filesystem::path& file, const WordImage& image, const Attributes& attributes = {});
void save_jpeg(const std::filesystem::path& file, const ByteImage& image, int quality);  // alpha is dropped
void save_webp(const std::filesystem::path& file, const ByteImage& image, int quality);  // 100: lossless
void save_exr(const std::filesystem::path& file, const FloatImage& image, bool half);    // premultiplied, as EXR asks
// Readers that know of one part only show the first. Each part carries the attributes.
void save_exr_parts(const std::filesystem::path& file, Size size, std::span<const ExrPart> parts,
                    const Attributes& attributes = {});
void save_hdr(const std::filesystem::path& file, const FloatImage& image);  // alpha is dropped

}  // namespace velarium::image
