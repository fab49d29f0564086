#include "parse.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>

#include <charconv>
#include <cmath>

namespace velarium::app {
namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& expected) {
  throw Error(ErrorCode::usage, fmt::format("'{}' is not {}", text, expected));
}

template <class Number, class... Base>
bool read_all(std::string_view text, Number& value, Base... base) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base...);
  return error == std::errc{} && end == text.data() + text.size();
}

bool read_real(std::string_view text, float& value) {
  if (text.starts_with('+')) text.remove_prefix(1);
  return read_all(text, value) && std::isfinite(value);
}

}  // namespace

float parse_number(std::string_view text) {
  float value = 0;
  if (!read_real(text, value)) refuse(text, "a number");
  return value;
}

std::uint32_t parse_count(std::string_view text, std::uint32_t least, std::uint32_t most) {
  std::uint32_t value = 0;
  if (!read_all(text, value) || value < least || value > most) {
    refuse(text, fmt::format("a whole number from {} to {}", least, most));
  }
  return value;
}

std::array<float, 3> parse_point(std::string_view text) {
  std::array<float, 3> point{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t comma = rest.find(',');
    const bool last = i == 2;
    if (last != (comma == std::string_view::npos) || !read_real(rest.substr(0, comma), point[i])) {
      refuse(text, "three numbers x,y,z");
    }
    rest.remove_prefix(last ? rest.size() : comma + 1);
  }
  return point;
}

Sun parse_sun(std::string_view text) {
  Sun sun;
  std::string_view rest = text;
  for (float* value : {&sun.azimuth_deg, &sun.elevation_deg, &sun.illuminance_lux}) {
    const std::size_t comma = rest.find(',');
    if (!read_real(rest.substr(0, comma), *value)) break;
    const bool last = comma == std::string_view::npos, enough = value != &sun.azimuth_deg;
    if (last && enough) return sun;
    if (last) break;
    rest.remove_prefix(comma + 1);
  }
  refuse(text, "AZIMUTH,ELEVATION in degrees, or these and LUX");
}

std::array<std::uint32_t, 2> parse_size(std::string_view text) {
  constexpr std::uint32_t kMost = 65535;  // of JPEG, and more than any device draws
  std::array<std::uint32_t, 2> size{};
  const std::size_t cross = text.find('x');
  const auto good = [&](std::string_view part, std::uint32_t& value) {
    return read_all(part, value) && value >= 1 && value <= kMost;
  };
  if (cross == std::string_view::npos || !good(text.substr(0, cross), size[0]) ||
      !good(text.substr(cross + 1), size[1])) {
    refuse(text, fmt::format("WIDTHxHEIGHT in pixels, each from 1 to {}, such as 1280x720", kMost));
  }
  return size;
}

std::array<float, 3> parse_color(std::string_view text) {
  std::uint32_t value = 0;
  if (text.size() != 7 || text[0] != '#' || !read_all(text.substr(1), value, 16)) refuse(text, "a colour #rrggbb");
  const auto channel = [value](int shift) { return static_cast<float>(value >> shift & 0xff) / 255.0f; };
  return {channel(16), channel(8), channel(0)};
}

std::pair<std::string, std::string> parse_pair(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0) refuse(text, "KEY=VALUE");
  return {std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

}  // namespace velarium::app
