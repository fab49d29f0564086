// Radiance pictures: Ward, "Real Pixels", Graphics Gems II (1991), and the file format section of Radiance's manual.

#include "image/codecs.hpp"

#include "core/assert.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string_view>

namespace velarium::image {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;  // three mantissas of 8 bits, one exponent with a bias of 128

// Lines of the newer run-length code are from 8 to 32767 pixels long; others are flat or in the older code.
constexpr std::uint32_t kMinRunWidth = 8, kMaxRunWidth = 0x7fff;

struct Header {
  Size size{};
  float scale = 1.0f;  // from stored values to radiance
};

// --- reading ------------------------------------------------------------------------------------------------------

class Reader {
 public:
  Reader(Bytes data, const std::string& what) : data_(data), what_(what) {}

  [[nodiscard]] std::string_view line() {
    const auto begin = data_.begin() + static_cast<std::ptrdiff_t>(position_);
    const auto end = std::find(begin, data_.end(), std::byte{'\n'});
    if (end == data_.end()) fail("the file ends in its header");
    const std::string_view text(reinterpret_cast<const char*>(data_.data()) + position_,
                                static_cast<std::size_t>(end - begin));
    position_ += text.size() + 1;
    return text.ends_with('\r') ? text.substr(0, text.size() - 1) : text;
  }
  [[nodiscard]] std::uint8_t byte() {
    if (position_ == data_.size()) fail("the file ends early");
    return static_cast<std::uint8_t>(data_[position_++]);
  }
  [[nodiscard]] Rgbe pixel() { return {byte(), byte(), byte(), byte()}; }
  void back(std::size_t count) { position_ -= count; }
  [[noreturn]] void fail(const std::string& reason) const {
    invalid(what_, fmt::format("Radiance: {} (at byte {})", reason, position_));
  }
  [[nodiscard]] const std::string& what() const { return what_; }

 private:
  Bytes data_;
  std::size_t position_ = 0;
  const std::string& what_;
};

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
  while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
  return text;
}

void read_format(const Reader& reader, std::string_view value) {
  if (value == "32-bit_rle_rgbe") return;
  throw Error(ErrorCode::unsupported, reader.what(),
              fmt::format("Radiance: the format '{}'; only 32-bit_rle_rgbe is supported", value));
}

// EXPOSURE lines multiply, and say by how much the stored values were multiplied.
void read_exposure(const Reader& reader, std::string_view value, Header& header) {
  float exposure = 0.0f;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), exposure);
  if (error != std::errc{} || end != value.data() + value.size() || !(exposure > 0.0f) || !std::isfinite(exposure)) {
    reader.fail(fmt::format("EXPOSURE is '{}', not a positive number", value));
  }
  header.scale /= exposure;
}

// "-Y height +X width": rows from the top, pixels from the left, as nearly all files have it.
Size read_resolution(const Reader& reader, std::string_view line) {
  Size size{};
  const auto number = [](std::string_view& text, std::uint32_t& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return error == std::errc{};
  };
  std::string_view rest = line;
  if (rest.size() > 2 && (rest[1] == 'X' || rest[1] == 'Y') && !rest.starts_with("-Y ")) {
    throw Error(ErrorCode::unsupported, reader.what(),
                fmt::format("Radiance: the orientation '{}'; only -Y +X is supported", line));
  }
  if (!rest.starts_with("-Y ")) reader.fail(fmt::format("'{}' is not a resolution", line.substr(0, 40)));
  rest.remove_prefix(3);
  bool good = number(rest, size.height);
  if (good && rest.starts_with(" -X ")) {
    throw Error(ErrorCode::unsupported, reader.what(),
                fmt::format("Radiance: the orientation '{}'; only -Y +X is supported", line));
  }
  good = good && rest.starts_with(" +X ");
  if (good) rest.remove_prefix(4);
  if (!good || !number(rest, size.width) || !rest.empty())
    reader.fail(fmt::format("'{}' is not a resolution", line.substr(0, 40)));
  return size;
}

Header read_header(Reader& reader) {
  Header header;
  for (std::string_view line; !(line = reader.line()).empty();) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos || line.starts_with('#')) continue;
    const std::string_view name = trimmed(line.substr(0, equals)), value = trimmed(line.substr(equals + 1));
    if (name == "FORMAT") read_format(reader, value);
    if (name == "EXPOSURE") read_exposure(reader, value, header);
  }
  header.size = read_resolution(reader, reader.line());
  return header;
}

// Newer code: the four components one after the other, each as runs (count > 128) and literals.
void read_component_runs(Reader& reader, std::span<Rgbe> row) {
  for (std::size_t component = 0; component < 4; ++component) {
    for (std::size_t x = 0; x < row.size();) {
      const std::uint8_t code = reader.byte();
      const bool run = code > 128;
      const std::size_t count = run ? code - 128u : code;
      if (count == 0 || count > row.size() - x) reader.fail("a run leaves its line");
      std::uint8_t value = run ? reader.byte() : 0;
      for (std::size_t i = 0; i < count; ++i, ++x) row[x][component] = run ? value : reader.byte();
    }
  }
}

// Flat pixels, among which (1, 1, 1, n) repeats the pixel before it n times, n << 8 times if it is the second in a row,
// ...
void read_pixel_runs(Reader& reader, std::span<Rgbe> row) {
  unsigned shift = 0;
  for (std::size_t x = 0; x < row.size();) {
    const Rgbe pixel = reader.pixel();
    if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
      row[x++] = pixel;
      shift = 0;
      continue;
    }
    const std::size_t count = static_cast<std::size_t>(pixel[3]) << shift;
    if (x == 0 || shift > 16 || count > row.size() - x) reader.fail("a run leaves its line");
    std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
    x += count;
    shift += 8;
  }
}

void read_row(Reader& reader, std::span<Rgbe> row) {
  if (row.size() < kMinRunWidth || row.size() > kMaxRunWidth) return read_pixel_runs(reader, row);
  const Rgbe start = reader.pixel();
  if (start[0] != 2 || start[1] != 2 || start[2] >= 128) {
    reader.back(4);
    return read_pixel_runs(reader, row);
  }
  if ((start[2] << 8 | start[3]) != static_cast<int>(row.size())) reader.fail("a line claims another width");
  read_component_runs(reader, row);
}

// 2^(exponent - 128 - 8). Mantissas are read without Ward's half step, as nearly all programs of today do, so that
// values which the format holds exactly, such as 1, come back as themselves.
std::array<float, 256> mantissa_scales(float scale) {
  std::array<float, 256> scales{};  // exponent 0 is black
  for (int e = 1; e < 256; ++e) scales[static_cast<std::size_t>(e)] = std::ldexp(scale, e - 136);
  return scales;
}

// --- writing ------------------------------------------------------------------------------------------------------

Rgbe encode(const float* rgb) {
  // What the format cannot hold: negative values and NaN become 0, larger ones its largest.
  constexpr float kLargest = 0x1.FEp126f;  // 255 * 2^(255 - 136)
  std::array<float, 3> value{};
  for (std::size_t c = 0; c < 3; ++c) value[c] = rgb[c] > 0.0f ? std::min(rgb[c], kLargest) : 0.0f;
  const float largest = *std::max_element(value.begin(), value.end());
  constexpr float kSmallest = 1e-32f;  // as Radiance: darker is black
  if (largest < kSmallest) return {};
  int exponent = 0;
  // A largest mantissa that would round up to 256 belongs to the next exponent.
  if (std::round(std::frexp(largest, &exponent) * 256.0f) > 255.0f) ++exponent;
  Rgbe pixel{};
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] = static_cast<std::uint8_t>(std::round(std::ldexp(value[c], 8 - exponent)));
  pixel[3] = static_cast<std::uint8_t>(exponent + 128);
  return pixel;
}

void put(std::vector<std::byte>& out, unsigned value) {
  out.push_back(static_cast<std::byte>(value));
}

std::size_t run_length(std::span<const Rgbe> row, std::size_t component, std::size_t x) {
  constexpr std::size_t kLongestRun = 127;
  std::size_t end = x + 1;
  while (end < row.size() && end - x < kLongestRun && row[end][component] == row[x][component]) ++end;
  return end - x;
}

void write_component_runs(std::vector<std::byte>& out, std::span<const Rgbe> row) {
  constexpr std::size_t kShortestRun = 4, kLongestLiteral = 128;  // a shorter run saves nothing
  for (std::size_t component = 0; component < 4; ++component) {
    for (std::size_t x = 0; x < row.size();) {
      const std::size_t run = run_length(row, component, x);
      if (run >= kShortestRun) {
        put(out, static_cast<unsigned>(128 + run));
        put(out, row[x][component]);
        x += run;
        continue;
      }
      std::size_t end = x + run;
      while (end < row.size() && end - x < kLongestLiteral && run_length(row, component, end) < kShortestRun) ++end;
      put(out, static_cast<unsigned>(end - x));
      for (; x < end; ++x) put(out, row[x][component]);
    }
  }
}

void write_row(std::vector<std::byte>& out, std::span<const Rgbe> row) {
  if (row.size() >= kMinRunWidth && row.size() <= kMaxRunWidth) {
    const auto width = static_cast<unsigned>(row.size());
    for (const unsigned value : {2u, 2u, width >> 8, width & 0xffu}) put(out, value);
    return write_component_runs(out, row);
  }
  for (const Rgbe& pixel : row) {
    for (const std::uint8_t value : pixel) put(out, value);
  }
}

}  // namespace

FloatImage read_hdr(Bytes data, const std::string& what, const Limits& limits) {
  Reader reader(data, what);
  const Header header = read_header(reader);
  check_size(header.size, what, limits);
  FloatImage image{header.size.width, header.size.height, std::vector<float>(channel_count(header.size), 1.0f)};
  const std::array<float, 256> scales = mantissa_scales(header.scale);
  std::vector<Rgbe> row(image.width);
  float* to = image.rgba.data();
  for (std::uint32_t y = 0; y < image.height; ++y) {
    read_row(reader, row);
    for (const Rgbe& pixel : row) {
      for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(pixel[c]) * scales[pixel[3]];
      to += 4;
    }
  }
  return image;
}

std::vector<std::byte> write_hdr(const FloatImage& image) {
  VEL_ASSERT(image.rgba.size() == channel_count({image.width, image.height}));
  const std::string header =
      fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", image.height, image.width);
  const Bytes header_bytes = std::as_bytes(std::span(header));
  std::vector<std::byte> out(header_bytes.begin(), header_bytes.end());
  std::vector<Rgbe> row(image.width);
  const float* from = image.rgba.data();
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (Rgbe& pixel : row) {
      pixel = encode(from);
      from += 4;
    }
    write_row(out, row);
  }
  return out;
}

}  // namespace velarium::image
