#include "image/codecs.hpp"

#include "core/huge_pages.hpp"
#include "core/log.hpp"

#include <turbojpeg.h>

#include <memory>
#include <string_view>

namespace velarium::image {
namespace {

struct Destroy {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<void, Destroy>;

Handle decompressor() {
  Handle handle(tjInitDecompress());
  if (handle == nullptr) throw Error(ErrorCode::temporary, "libjpeg-turbo: out of memory");
  return handle;
}

struct Header {
  Size size;
  bool cmyk;
};

const unsigned char* data_of(Bytes data) {
  return reinterpret_cast<const unsigned char*>(data.data());
}

Header read_header(tjhandle handle, Bytes data, const std::string& what) {
  int width = 0, height = 0, subsampling = 0, space = 0;
  if (tjDecompressHeader3(handle, data_of(data), data.size(), &width, &height, &subsampling, &space) != 0) {
    invalid(what, fmt::format("JPEG: {}", tjGetErrorStr2(handle)));
  }
  return {{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)},
          space == TJCS_CMYK || space == TJCS_YCCK};
}

// Rubbish between two markers is skipped and harms no pixel. Every other warning means that pixels were guessed.
void check_decoded(tjhandle handle, int result, const std::string& what) {
  if (result == 0) return;
  const std::string_view message = tjGetErrorStr2(handle);
  const bool harmless = tjGetErrorCode(handle) == TJERR_WARNING && message.find("extraneous") != std::string_view::npos;
  if (!harmless) invalid(what, fmt::format("JPEG: {}", message));
  log_warning("{}: JPEG: {}", what, message);
}

// Files with four channels come from Adobe's programs, which store each ink inverted: 255 is no ink.
void rgba_from_inverted_cmyk(std::vector<std::uint8_t>& pixels) {
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    const unsigned black = pixels[i + 3];
    for (std::size_t c = 0; c < 3; ++c) pixels[i + c] = static_cast<std::uint8_t>((pixels[i + c] * black + 127) / 255);
    pixels[i + 3] = 255;
  }
}

}  // namespace

Size jpeg_size(Bytes data, const std::string& what) {
  return read_header(decompressor().get(), data, what).size;
}

ByteImage read_jpeg(Bytes data, const std::string& what, const Limits& limits) {
  const Handle handle = decompressor();
  const Header header = read_header(handle.get(), data, what);
  check_size(header.size, what, limits);
  ByteImage image{header.size.width, header.size.height, {}};
  reserve_on_huge_pages(image.rgba, channel_count(header.size));
  image.rgba.resize(channel_count(header.size));
  // A small progressive file can hold scans for hours: libjpeg-turbo then stops at 500.
  const int result =
      tjDecompress2(handle.get(), data_of(data), data.size(), image.rgba.data(), static_cast<int>(image.width), 0,
                    static_cast<int>(image.height), header.cmyk ? TJPF_CMYK : TJPF_RGBA, TJFLAG_LIMITSCANS);
  check_decoded(handle.get(), result, what);
  if (header.cmyk) rgba_from_inverted_cmyk(image.rgba);
  return image;
}

std::vector<std::byte> write_jpeg(const ByteImage& image, int quality, const std::string& what) {
  const Handle handle(tjInitCompress());
  if (handle == nullptr) throw Error(ErrorCode::temporary, "libjpeg-turbo: out of memory");
  unsigned char* data = nullptr;
  unsigned long size = 0;
  // Full colour resolution: rendered edges between saturated colours show what subsampling loses.
  const int result =
      tjCompress2(handle.get(), image.rgba.data(), static_cast<int>(image.width), 0, static_cast<int>(image.height),
                  TJPF_RGBA, &data, &size, TJSAMP_444, quality, TJFLAG_ACCURATEDCT);
  const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owner(data, tjFree);
  if (result != 0) {
    throw Error(ErrorCode::output_not_written, what, fmt::format("JPEG: {}", tjGetErrorStr2(handle.get())));
  }
  const Bytes bytes = std::as_bytes(std::span(data, size));
  return {bytes.begin(), bytes.end()};
}

}  // namespace velarium::image
