#include "image/codecs.hpp"

#include <webp/decode.h>
#include <webp/encode.h>

#include <algorithm>

namespace velarium::image {
namespace {

const std::uint8_t* data_of(Bytes data) {
  return reinterpret_cast<const std::uint8_t*>(data.data());
}

std::string_view reason(VP8StatusCode status) {
  switch (status) {
    case VP8_STATUS_NOT_ENOUGH_DATA:
      return "the file ends early";
    case VP8_STATUS_OUT_OF_MEMORY:
      return "out of memory";
    case VP8_STATUS_UNSUPPORTED_FEATURE:
      return "a feature that libwebp does not support";
    default:
      return "the data is malformed";
  }
}

std::string_view reason(WebPEncodingError error) {
  switch (error) {
    case VP8_ENC_ERROR_BAD_DIMENSION:
      return "pictures of this format have at most 16383 pixels a side";
    case VP8_ENC_ERROR_OUT_OF_MEMORY:
    case VP8_ENC_ERROR_BITSTREAM_OUT_OF_MEMORY:
      return "out of memory";
    default:
      return "libwebp cannot encode it";
  }
}

// A WebPPicture and the bytes that it is encoded to.
class Encoding {
 public:
  Encoding() {
    WebPPictureInit(&picture_);
    WebPMemoryWriterInit(&writer_);
    picture_.writer = WebPMemoryWrite;
    picture_.custom_ptr = &writer_;
  }
  ~Encoding() {
    WebPPictureFree(&picture_);
    WebPMemoryWriterClear(&writer_);
  }
  Encoding(const Encoding&) = delete;
  Encoding& operator=(const Encoding&) = delete;

  [[nodiscard]] bool encode(const ByteImage& image, const WebPConfig& config) {
    picture_.width = static_cast<int>(image.width);
    picture_.height = static_cast<int>(image.height);
    picture_.use_argb = config.lossless;
    return WebPPictureImportRGBA(&picture_, image.rgba.data(), picture_.width * 4) != 0 &&
           WebPEncode(&config, &picture_) != 0;
  }
  [[nodiscard]] WebPEncodingError error() const { return picture_.error_code; }
  [[nodiscard]] Bytes data() const { return std::as_bytes(std::span(writer_.mem, writer_.size)); }

 private:
  WebPPicture picture_{};
  WebPMemoryWriter writer_{};
};

}  // namespace

Size webp_size(Bytes data, const std::string& what) {
  WebPBitstreamFeatures features{};
  const VP8StatusCode status = WebPGetFeatures(data_of(data), data.size(), &features);
  if (status != VP8_STATUS_OK) invalid(what, fmt::format("WebP: {}", reason(status)));
  if (features.has_animation != 0) throw Error(ErrorCode::unsupported, what, "WebP: animations are not supported");
  return {static_cast<std::uint32_t>(features.width), static_cast<std::uint32_t>(features.height)};
}

ByteImage read_webp(Bytes data, const std::string& what, const Limits& limits) {
  const Size size = webp_size(data, what);
  check_size(size, what, limits);
  ByteImage image{size.width, size.height, std::vector<std::uint8_t>(channel_count(size))};
  WebPDecoderConfig config;
  WebPInitDecoderConfig(&config);
  config.output.colorspace = MODE_RGBA;
  config.output.is_external_memory = 1;
  config.output.u.RGBA = {image.rgba.data(), static_cast<int>(4 * size.width), image.rgba.size()};
  const VP8StatusCode status = WebPDecode(data_of(data), data.size(), &config);
  // Data that ends early decodes in part; libwebp calls that suspended.
  if (status != VP8_STATUS_OK) {
    invalid(what,
            fmt::format("WebP: {}", reason(status == VP8_STATUS_SUSPENDED ? VP8_STATUS_NOT_ENOUGH_DATA : status)));
  }
  return image;
}

std::vector<std::byte> write_webp(const ByteImage& image, int quality, const std::string& what) {
  WebPConfig config;
  WebPConfigInit(&config);
  config.lossless = quality == 100 ? 1 : 0;
  config.exact = 1;                                                             // keep the colour of transparent pixels
  config.quality = config.lossless != 0 ? 50.0f : static_cast<float>(quality);  // lossless: effort, not loss
  Encoding encoding;
  if (!encoding.encode(image, config)) {
    throw Error(ErrorCode::output_not_written, what, fmt::format("WebP: {}", reason(encoding.error())));
  }
  return {encoding.data().begin(), encoding.data().end()};
}

}  // namespace velarium::image
