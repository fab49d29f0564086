#include "image/codecs.hpp"

#include "core/assert.hpp"
#include "core/huge_pages.hpp"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <csetjmp>
#include <cstring>

// libpng leaves a failing call by longjmp, which runs no destructor. So each function here that calls setjmp has only
// trivial objects of its own: what owns memory lives in its caller, and is passed to it.

namespace velarium::image {
namespace {

// The signature (8 bytes), then the IHDR chunk: length, type, width, height, bit depth (W3C PNG, 5.2 and 11.2.2).
constexpr std::size_t kIhdrType = 12, kWidth = 16, kHeight = 20, kBitDepth = 24, kHeaderEnd = 33;

std::uint32_t big_endian(Bytes data, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint32_t>(data[offset + i]);
  return value;
}

// What libpng calls back with.
struct Session {
  Bytes unread;
  std::vector<std::byte> written;
  std::string failure;
};

void on_error(png_structp png, png_const_charp message) {
  static_cast<Session*>(png_get_error_ptr(png))->failure = message;
  png_longjmp(png, 1);
}

// libpng warns of metadata that is ignored here (colour profiles, text).
void on_warning(png_structp, png_const_charp) {}

void on_read(png_structp png, png_bytep to, std::size_t size) {
  Bytes& unread = static_cast<Session*>(png_get_io_ptr(png))->unread;
  if (size > unread.size()) png_error(png, "the file ends early");
  std::memcpy(to, unread.data(), size);
  unread = unread.subspan(size);
}

void on_write(png_structp png, png_bytep from, std::size_t size) {
  std::vector<std::byte>& written = static_cast<Session*>(png_get_io_ptr(png))->written;
  const auto* begin = reinterpret_cast<const std::byte*>(from);
  written.insert(written.end(), begin, begin + size);
}

class Reader {
 public:
  explicit Reader(Session& session)
      : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &session, on_error, on_warning)),
        info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {
    if (info_ == nullptr) throw Error(ErrorCode::temporary, "libpng: out of memory");
    png_set_read_fn(png_, &session, on_read);
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  // Fills rows with RGBA of 8 or 16 bits a channel. False: session.failure says why.
  [[nodiscard]] bool read(png_bytepp rows, int bits) noexcept {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    // Gamma and profiles are not applied (glTF 2.0, 3.8.3), and a broken profile is no reason to refuse an image.
    static const png_byte kIgnored[] = "iCCP\0gAMA\0cHRM\0tEXt\0zTXt\0iTXt\0eXIf";
    png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, kIgnored, sizeof kIgnored / 5);
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // check_size() has seen the header
    png_read_info(png_, info_);
    png_set_expand(png_);
    if (bits == 8) png_set_scale_16(png_);
    if (bits == 16) png_set_expand_16(png_);
    if (bits == 16 && std::endian::native == std::endian::little) png_set_swap(png_);
    png_set_gray_to_rgb(png_);
    png_set_add_alpha(png_, bits == 8 ? 0xff : 0xffff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

 private:
  png_structp png_;
  png_infop info_;
};

class Writer {
 public:
  explicit Writer(Session& session)
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &session, on_error, on_warning)),
        info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {
    if (info_ == nullptr) throw Error(ErrorCode::temporary, "libpng: out of memory");
    png_set_write_fn(png_, &session, on_write, nullptr);
  }
  ~Writer() { png_destroy_write_struct(&png_, &info_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  [[nodiscard]] bool write(png_bytepp rows, Size size, int bits, bool with_alpha,
                           const std::vector<png_text>& texts) noexcept {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png_, info_, size.width, size.height, bits, with_alpha ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
    // Paeth's filter leaves noise and runs, so that matching runs alone finds what there is: on rendered pictures 2.5
    // times as fast as matching strings at level 4, and as small (docs/performance.md).
    png_set_compression_strategy(png_, Z_RLE);
    png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_PAETH);
    if (!texts.empty()) png_set_text(png_, info_, texts.data(), static_cast<int>(texts.size()));
    png_write_info(png_, info_);
    if (!with_alpha) png_set_filler(png_, 0, PNG_FILLER_AFTER);
    if (bits == 16 && std::endian::native == std::endian::little) png_set_swap(png_);
    png_write_image(png_, rows);
    png_write_end(png_, nullptr);
    return true;
  }

 private:
  png_structp png_;
  png_infop info_;
};

template <class Channel>
std::vector<png_bytep> row_pointers(Channel* rgba, Size size) {
  std::vector<png_bytep> rows(size.height);
  for (std::size_t y = 0; y < size.height; ++y)
    rows[y] = reinterpret_cast<png_bytep>(rgba + channel_count({size.width, 1}) * y);
  return rows;
}

// Each chunk is a length, a type, so many bytes, and a checksum (W3C PNG, 5.3). libpng believes the length, and asks
// for that much memory before it reads.
void check_chunks(Bytes data, const std::string& what) {
  constexpr std::size_t kSignature = 8, kType = 4, kFraming = 12;
  for (std::size_t at = kSignature; data.size() - at >= kFraming;) {
    const std::uint32_t length = big_endian(data, at);
    if (length > data.size() - at - kFraming)
      invalid(what, fmt::format("PNG: the file ends in the chunk at byte {}, which claims {} bytes", at, length));
    if (std::memcmp(data.data() + at + kType, "IEND", 4) == 0) return;
    at += kFraming + length;
  }
  invalid(what, "PNG: the file ends without its last chunk, IEND");
}

template <class Image>
Image read(Bytes data, const std::string& what, const Limits& limits) {
  const Size size = png_size(data, what);
  check_size(size, what, limits);
  check_chunks(data, what);
  Image image{size.width, size.height, {}};
  reserve_on_huge_pages(image.rgba, channel_count(size));
  image.rgba.resize(channel_count(size));
  std::vector<png_bytep> rows = row_pointers(image.rgba.data(), size);
  Session session{data, {}, {}};
  Reader reader(session);
  if (!reader.read(rows.data(), 8 * sizeof image.rgba[0])) invalid(what, "PNG: " + session.failure);
  return image;
}

// Refer to the attributes. libpng only reads through its pointers.
std::vector<png_text> texts_of(const Attributes& attributes) {
  std::vector<png_text> texts;
  for (const auto& [name, text] : attributes) {
    png_text& added = texts.emplace_back();
    added.compression = PNG_TEXT_COMPRESSION_NONE;
    added.key = const_cast<char*>(name.c_str());
    added.text = const_cast<char*>(text.c_str());
    added.text_length = text.size();
  }
  return texts;
}

template <class Image>
std::vector<std::byte> write(const Image& image, const std::string& what, const Attributes& attributes) {
  using Channel = typename decltype(image.rgba)::value_type;
  const Size size{image.width, image.height};
  VEL_ASSERT(image.rgba.size() == channel_count(size));
  bool opaque = true;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    opaque = opaque && image.rgba[i] == static_cast<Channel>(~Channel{0});
  // libpng takes rows that it may change, and does not change them where no transformation asks for it.
  std::vector<png_bytep> rows = row_pointers(const_cast<Channel*>(image.rgba.data()), size);
  const std::vector<png_text> texts = texts_of(attributes);
  Session session;
  Writer writer(session);
  if (!writer.write(rows.data(), size, 8 * sizeof(Channel), !opaque, texts)) {
    throw Error(ErrorCode::output_not_written, what, "PNG: " + session.failure);
  }
  return std::move(session.written);
}

}  // namespace

Size png_size(Bytes data, const std::string& what) {
  if (data.size() < kHeaderEnd) invalid(what, "PNG: the file ends in its header");
  if (std::memcmp(data.data() + kIhdrType, "IHDR", 4) != 0) invalid(what, "PNG: the first chunk is not IHDR");
  return {big_endian(data, kWidth), big_endian(data, kHeight)};
}

bool png_has_16_bits(Bytes data) {
  return data[kBitDepth] == std::byte{16};
}

ByteImage read_png(Bytes data, const std::string& what, const Limits& limits) {
  return read<ByteImage>(data, what, limits);
}
WordImage read_png_16(Bytes data, const std::string& what, const Limits& limits) {
  return read<WordImage>(data, what, limits);
}
std::vector<std::byte> write_png(const ByteImage& image, const std::string& what, const Attributes& attributes) {
  return write(image, what, attributes);
}
std::vector<std::byte> write_png(const WordImage& image, const std::string& what, const Attributes& attributes) {
  return write(image, what, attributes);
}

}  // namespace velarium::image
