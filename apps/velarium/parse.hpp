#pragma once

// Text of the command line and of configuration files to values. All throw Error(usage) that says what was expected.

#include <velarium/engine.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace velarium::app {

[[nodiscard]] float parse_number(std::string_view text);  // finite
[[nodiscard]] std::uint32_t parse_count(std::string_view text, std::uint32_t least, std::uint32_t most);
[[nodiscard]] std::array<float, 3> parse_point(std::string_view text);  // "x,y,z"
// "AZ,EL", or "AZ,EL,LUX": degrees and lux. Ranges are the library's to check.
[[nodiscard]] Sun parse_sun(std::string_view text);
[[nodiscard]] std::array<std::uint32_t, 2> parse_size(std::string_view text);         // "WIDTHxHEIGHT", each 1..65535
[[nodiscard]] std::array<float, 3> parse_color(std::string_view text);                // "#rrggbb" to 0..1
[[nodiscard]] std::pair<std::string, std::string> parse_pair(std::string_view text);  // "KEY=VALUE"

}  // namespace velarium::app
