#include "scene/builtin.hpp"

#include <velarium/error.hpp>

#include "scenes/scenes.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

namespace velarium::scene {
namespace {

// At most one parameter each so far; a scene without takes no key.
struct Entry {
  const char* name;
  const char* key;  // nullptr: none
  std::uint32_t standard, least, most;
  const char* meaning;
  Scene (*make)(std::uint32_t);
};

template <Scene (*Make)()>
Scene without_parameter(std::uint32_t) {
  return Make();
}

template <Scene (*Make)()>
constexpr Entry plain(const char* name) {
  return {name, nullptr, 0, 0, 0, "", without_parameter<Make>};
}

constexpr std::array<Entry, 6> kEntries{{
    {"atrium", "lights", kTorches, 0, 4096,
     "lamps that share the light of the 24 torches; 24 stand at the torches, others spread over the court",
     atrium_scene},
    plain<spheres_scene>("spheres"),
    plain<furnace_scene>("furnace"),
    plain<cornell_scene>("cornell"),
    {"knots", "instances", 256, 1, 65536, "copies of one knot, on a disc of one size", knots_scene},
    {"terrain", "triangles", 500'000, 10'000, 10'000'000, "triangles of the land, within a hundredth", terrain_scene},
}};

// The name alone, and the text after "?" where there is one.
struct Request {
  const Entry& entry;
  std::optional<std::string_view> query;
};

Request parse_name(std::string_view name) {
  const std::size_t mark = name.find('?');
  for (const Entry& entry : kEntries) {
    if (entry.name != name.substr(0, mark)) continue;
    if (mark == std::string_view::npos) return {entry, std::nullopt};
    return {entry, name.substr(mark + 1)};
  }
  throw Error(ErrorCode::input_missing, fmt::format("builtin:{}", name),
              fmt::format("no such scene; there are: {}", fmt::join(builtin_names(), ", ")));
}

[[noreturn]] void refuse(const Entry& entry, std::string_view item) {
  const std::string keys = entry.key == nullptr ? "none"
                                                : fmt::format("{}={}..{} [{}]: {}", entry.key, entry.least, entry.most,
                                                              entry.standard, entry.meaning);
  throw Error(ErrorCode::usage, fmt::format("builtin:{}", entry.name),
              fmt::format("'{}' is not a parameter of this scene; there are: {}", item, keys));
}

std::uint32_t parse_item(const Entry& entry, std::string_view item) {
  const std::size_t equals = item.find('=');
  if (entry.key == nullptr || equals == std::string_view::npos || item.substr(0, equals) != entry.key)
    refuse(entry, item);
  const std::string_view text = item.substr(equals + 1);
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  if (!whole || value < entry.least || value > entry.most) refuse(entry, item);
  return value;
}

// The last of several values counts, as on the command line.
std::uint32_t value_of(const Request& request) {
  std::uint32_t value = request.entry.standard;
  if (!request.query) return value;
  for (std::string_view rest = *request.query;;) {
    const std::size_t end = rest.find('&');
    value = parse_item(request.entry, rest.substr(0, end));
    if (end == std::string_view::npos) return value;
    rest.remove_prefix(end + 1);
  }
}

}  // namespace

std::vector<std::string> builtin_names() {
  std::vector<std::string> names;
  for (const Entry& entry : kEntries) names.emplace_back(entry.name);
  return names;
}

std::vector<BuiltinParameter> builtin_parameters(const std::string& name) {
  const Request request = parse_name(name);
  const std::uint32_t value = value_of(request);
  const Entry& entry = request.entry;
  if (entry.key == nullptr) return {};
  return {{entry.key, value, entry.least, entry.most, entry.meaning}};
}

Scene builtin_scene(const std::string& name) {
  const Request request = parse_name(name);
  Scene scene = request.entry.make(value_of(request));
  scene.source = "builtin:" + name;
  return scene;
}

}  // namespace velarium::scene
