#include "image/codecs.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace velarium::image {
namespace {

// KTX File Format 2.0, section 3.1.
constexpr std::string_view kKtx2Magic = "\xabKTX 20\xbb\r\n\x1a\n";

bool starts_with(Bytes data, std::string_view magic, std::size_t offset = 0) {
  return data.size() >= offset + magic.size() && std::memcmp(data.data() + offset, magic.data(), magic.size()) == 0;
}

[[noreturn]] void not_an_image(Bytes data, const std::string& what) {
  if (starts_with(data, kKtx2Magic))
    throw Error(ErrorCode::unsupported, what, "is a KTX2 image, which this program does not support; export it as PNG");
  invalid(what, data.empty() ? "is empty" : "is not a PNG, JPEG or WebP image");
}

}  // namespace

Format format_of(Bytes data) {
  if (starts_with(data, "\x89PNG\r\n\x1a\n")) return Format::png;
  if (starts_with(data, "\xff\xd8\xff")) return Format::jpeg;
  if (starts_with(data, "RIFF") && starts_with(data, "WEBP", 8)) return Format::webp;
  if (starts_with(data, "\x76\x2f\x31\x01")) return Format::exr;
  if (starts_with(data, "#?")) return Format::hdr;
  return Format::unknown;
}

void check_size(Size size, const std::string& what, const Limits& limits) {
  if (size.width == 0 || size.height == 0) invalid(what, fmt::format("is {} x {} pixels", size.width, size.height));
  if (std::max(size.width, size.height) > limits.size) {
    invalid(what,
            fmt::format("is {} x {} pixels, more than the limit of {} a side", size.width, size.height, limits.size));
  }
  if (static_cast<std::uint64_t>(size.width) * size.height > limits.pixels) {
    invalid(what,
            fmt::format("is {} x {} pixels, more than the limit of {} in all", size.width, size.height, limits.pixels));
  }
}

ByteImage decode(Bytes data, const std::string& what, const Limits& limits) {
  switch (format_of(data)) {
    case Format::png:
      return read_png(data, what, limits);
    case Format::jpeg:
      return read_jpeg(data, what, limits);
    case Format::webp:
      return read_webp(data, what, limits);
    default:
      not_an_image(data, what);
  }
}

Size peek_size(Bytes data, const std::string& what) {
  switch (format_of(data)) {
    case Format::png:
      return png_size(data, what);
    case Format::jpeg:
      return jpeg_size(data, what);
    case Format::webp:
      return webp_size(data, what);
    default:
      not_an_image(data, what);
  }
}

}  // namespace velarium::image
