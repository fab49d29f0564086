#include "scene/builtin.hpp"

#include <velarium/error.hpp>

#include "scenes/scenes.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <string_view>

namespace velarium::scene {
namespace {

struct Parameter {
  const char* key;
  std::uint32_t standard, least, most;
  const char* meaning;
  std::span<const char* const> names;  // of the values from 0 on; none: the number itself is written
};

using Values = std::span<const std::uint32_t>;  // one a parameter

struct Entry {
  const char* name;
  std::span<const Parameter> parameters;
  Scene (*make)(Values);
};

constexpr const char* kSwitch[] = {"off", "on"};

constexpr Parameter kAtriumParameters[] = {
    {"lights",
     kTorches,
     0,
     4096,
     "lamps that share the light of the 24 torches; 24 stand at the torches, others spread over the court",
     {}},
    {"sun", 1, 0, 1, "a low sun, torches as large as their flames, a lantern that throws a pattern", kSwitch}};
constexpr Parameter kKnotsParameters[] = {
    {"instances", 256, 1, 65536, "copies of one knot, on a disc of one size", {}}};
constexpr Parameter kTerrainParameters[] = {
    {"triangles", 500'000, 10'000, 10'000'000, "triangles of the land, within a hundredth", {}}};

constexpr const char* kLightKinds[] = {"sun", "point", "spot"};  // in the order of LightKind
constexpr Parameter kBoxesParameters[] = {
    {"light", 0, 0, 2, "the one light there is", kLightKinds},
    {"radius", 0, 0, 1000, "of the light: millimetres of a bulb, thousandths of a radian of the sun's disc", {}},
    {"sheet", 1, 0, 1, "a sheet that half of the light passes", kSwitch}};

template <Scene (*Make)()>
Scene without_parameter(Values) {
  return Make();
}

template <Scene (*Make)(std::uint32_t)>
Scene with_number(Values values) {
  return Make(values[0]);
}

Scene atrium(Values values) {
  return atrium_scene(values[0], values[1] == 1);
}

Scene boxes(Values values) {
  return boxes_scene(static_cast<LightKind>(values[0]), 0.001f * static_cast<float>(values[1]), values[2] == 1);
}

constexpr Entry kEntries[] = {
    {"atrium", kAtriumParameters, atrium},
    {"spheres", {}, without_parameter<spheres_scene>},
    {"furnace", {}, without_parameter<furnace_scene>},
    {"cornell", {}, without_parameter<cornell_scene>},
    {"boxes", kBoxesParameters, boxes},
    {"knots", kKnotsParameters, with_number<knots_scene>},
    {"terrain", kTerrainParameters, with_number<terrain_scene>},
};

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

std::string described(const Parameter& p) {
  if (!p.names.empty())
    return fmt::format("{}={} [{}]: {}", p.key, fmt::join(p.names, "|"), p.names[p.standard], p.meaning);
  return fmt::format("{}={}..{} [{}]: {}", p.key, p.least, p.most, p.standard, p.meaning);
}

[[noreturn]] void refuse(const Entry& entry, std::string_view item) {
  std::vector<std::string> texts;
  for (const Parameter& p : entry.parameters) texts.push_back(described(p));
  throw Error(ErrorCode::usage, fmt::format("builtin:{}", entry.name),
              fmt::format("'{}' is not a parameter of this scene; there are: {}", item,
                          texts.empty() ? "none" : fmt::format("{}", fmt::join(texts, "; "))));
}

std::optional<std::uint32_t> parse_value(const Parameter& parameter, std::string_view text) {
  if (!parameter.names.empty()) {
    const auto found = std::find(parameter.names.begin(), parameter.names.end(), text);
    if (found == parameter.names.end()) return std::nullopt;
    return static_cast<std::uint32_t>(found - parameter.names.begin());
  }
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  if (!whole || value < parameter.least || value > parameter.most) return std::nullopt;
  return value;
}

void read_item(const Entry& entry, std::string_view item, std::vector<std::uint32_t>& values) {
  const std::size_t equals = item.find('=');
  if (equals == std::string_view::npos) refuse(entry, item);
  const auto parameter = std::find_if(entry.parameters.begin(), entry.parameters.end(),
                                      [&](const Parameter& p) { return p.key == item.substr(0, equals); });
  if (parameter == entry.parameters.end()) refuse(entry, item);
  const auto value = parse_value(*parameter, item.substr(equals + 1));
  if (!value) refuse(entry, item);
  values[static_cast<std::size_t>(parameter - entry.parameters.begin())] = *value;
}

// One a parameter. The last of several of one key counts, as on the command line.
std::vector<std::uint32_t> values_of(const Request& request) {
  std::vector<std::uint32_t> values;
  for (const Parameter& p : request.entry.parameters) values.push_back(p.standard);
  if (!request.query) return values;
  for (std::string_view rest = *request.query;;) {
    const std::size_t end = rest.find('&');
    read_item(request.entry, rest.substr(0, end), values);
    if (end == std::string_view::npos) return values;
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
  const std::vector<std::uint32_t> values = values_of(request);
  std::vector<BuiltinParameter> parameters;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Parameter& p = request.entry.parameters[i];
    parameters.push_back({p.key, values[i], p.least, p.most, p.meaning, {p.names.begin(), p.names.end()}});
  }
  return parameters;
}

Scene builtin_scene(const std::string& name) {
  const Request request = parse_name(name);
  Scene scene = request.entry.make(values_of(request));
  scene.source = "builtin:" + name;
  return scene;
}

}  // namespace velarium::scene
