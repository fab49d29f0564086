// Radiance pictures: Ward, "Real Pixels", Graphics Gems II (1991), and the file format section of Radiance's manual.

#include "image/codecs.hpp"

#include "core/assert.hpp"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

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

// Where pixels go as they are read: lines one after the other, along rows or columns, from either end.
struct Order {
  bool columns = false;  // lines are columns
  bool from_right = false, from_bottom = false;
};

struct Header {
  Size size{};
  Order order;
  glm::vec3 scale{1.0f};  // from stored values to radiance
  bool xyz = false;       // CIE XYZ instead of red, green, blue
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

void read_format(const Reader& reader, std::string_view value, Header& header) {
  header.xyz = value == "32-bit_rle_xyze";
  if (header.xyz || value == "32-bit_rle_rgbe") return;
  throw Error(ErrorCode::unsupported, reader.what(),
              fmt::format("Radiance: the format '{}'; 32-bit_rle_rgbe and 32-bit_rle_xyze are supported", value));
}

// One positive number, or as many as asked for, with blanks between.
std::vector<float> read_factors(const Reader& reader, std::string_view name, std::string_view value,
                                std::size_t count) {
  std::vector<float> factors;
  std::string_view rest = value;
  while (!rest.empty()) {
    float factor = 0.0f;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), factor);
    if (error != std::errc{} || !(factor > 0.0f) || !std::isfinite(factor)) break;
    factors.push_back(factor);
    rest = trimmed(rest.substr(static_cast<std::size_t>(end - rest.data())));
  }
  if (!rest.empty() || factors.size() != count)
    reader.fail(
        fmt::format("{} is '{}', not {}", name, value, count == 1 ? "a positive number" : "three positive numbers"));
  return factors;
}

// EXPOSURE and COLORCORR lines multiply, and say by how much the stored values were multiplied.
void read_exposure(const Reader& reader, std::string_view value, Header& header) {
  header.scale /= read_factors(reader, "EXPOSURE", value, 1)[0];
}

void read_color_correction(const Reader& reader, std::string_view value, Header& header) {
  const std::vector<float> factors = read_factors(reader, "COLORCORR", value, 3);
  header.scale /= glm::vec3(factors[0], factors[1], factors[2]);
}

// "-Y height +X width": rows from the top, pixels from the left, as nearly all files have it. The axis that comes first
// is that of the lines; a plus before Y says that they start at the bottom, a minus before X that they start at the
// right.
void read_resolution(const Reader& reader, std::string_view line, Header& header) {
  std::string_view rest = line;
  const auto axis = [&](char& sign, char& name, std::uint32_t& value) {
    if (rest.size() < 4 || (rest[0] != '+' && rest[0] != '-') || (rest[1] != 'X' && rest[1] != 'Y') || rest[2] != ' ')
      return false;
    sign = rest[0];
    name = rest[1];
    rest.remove_prefix(3);
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    return error == std::errc{};
  };
  char signs[2]{}, names[2]{};
  std::uint32_t values[2]{};
  bool good = axis(signs[0], names[0], values[0]) && rest.starts_with(' ');
  if (good) rest.remove_prefix(1);
  if (!good || !axis(signs[1], names[1], values[1]) || !rest.empty() || names[0] == names[1])
    reader.fail(fmt::format("'{}' is not a resolution", line.substr(0, 40)));
  const std::size_t y = names[0] == 'Y' ? 0 : 1, x = 1 - y;
  header.size = {values[x], values[y]};
  header.order = {.columns = y == 1, .from_right = signs[x] == '-', .from_bottom = signs[y] == '+'};
}

Header read_header(Reader& reader) {
  Header header;
  for (std::string_view line; !(line = reader.line()).empty();) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos || line.starts_with('#')) continue;
    const std::string_view name = trimmed(line.substr(0, equals)), value = trimmed(line.substr(equals + 1));
    if (name == "FORMAT") read_format(reader, value, header);
    if (name == "EXPOSURE") read_exposure(reader, value, header);
    if (name == "COLORCORR") read_color_correction(reader, value, header);
  }
  read_resolution(reader, reader.line(), header);
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
std::array<float, 256> mantissa_scales() {
  std::array<float, 256> scales{};  // exponent 0 is black
  for (int e = 1; e < 256; ++e) scales[static_cast<std::size_t>(e)] = std::ldexp(1.0f, e - 136);
  return scales;
}

// To BT.709's primaries and white, D65 (IEC 61966-2-1, annex F).
glm::vec3 rgb_of_xyz(const glm::vec3& xyz) {
  constexpr glm::mat3 kMatrix{
      {3.2406f, -0.9689f, 0.0557f}, {-1.5372f, 1.8758f, -0.2040f}, {-0.4986f, 0.0415f, 1.0570f}};
  return glm::max(kMatrix * xyz, glm::vec3(0.0f));
}

// Where the pixel of this number on this line goes, in pixels from the top left.
std::size_t place_of(const Header& header, std::uint32_t line, std::uint32_t number) {
  const auto [width, height] = header.size;
  const std::uint32_t column = header.order.columns ? line : number, row = header.order.columns ? number : line;
  const std::uint32_t x = header.order.from_right ? width - 1 - column : column;
  const std::uint32_t y = header.order.from_bottom ? height - 1 - row : row;
  return std::size_t{y} * width + x;
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
  const std::array<float, 256> scales = mantissa_scales();
  std::vector<Rgbe> pixels(header.order.columns ? image.height : image.width);
  const std::uint32_t lines = header.order.columns ? image.width : image.height;
  for (std::uint32_t line = 0; line < lines; ++line) {
    read_row(reader, pixels);
    for (std::uint32_t i = 0; i < pixels.size(); ++i) {
      const Rgbe& pixel = pixels[i];
      const glm::vec3 stored(pixel[0], pixel[1], pixel[2]);
      const glm::vec3 value = stored * scales[pixel[3]] * header.scale;
      const glm::vec3 rgb = header.xyz ? rgb_of_xyz(value) : value;
      float* to = image.rgba.data() + 4 * place_of(header, line, i);
      for (int c = 0; c < 3; ++c) to[c] = rgb[c];
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
