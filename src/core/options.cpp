#include <velarium/options.hpp>

#include "core/enum_names.hpp"
#include "core/log.hpp"

#include <velarium/error.hpp>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <type_traits>

namespace velarium {
namespace {

struct Row {
  OptionInfo info;
  std::function<void(Settings&, std::string_view)> set;
  std::function<std::string(const Settings&)> get;
};

[[noreturn]] void refuse(std::string_view key, std::string_view value, const std::string& expected) {
  throw Error(ErrorCode::usage, fmt::format("{}: '{}' is not {}", key, value, expected));
}

bool parse_bool(std::string_view key, std::string_view text) {
  if (text == "on" || text == "true" || text == "1") return true;
  if (text == "off" || text == "false" || text == "0") return false;
  refuse(key, text, "one of on, off, true, false, 1, 0");
}

template <class Number>
Number parse_number(const OptionInfo& info, std::string_view text) {
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  Number value{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool whole_text = error == std::errc{} && end == digits.data() + digits.size();
  const auto wide = static_cast<double>(value);
  // Written so that a NaN is refused as well.
  if (!whole_text || !(wide >= info.minimum && wide <= info.maximum)) {
    refuse(info.key, text, (std::is_integral_v<Number> ? "a whole number " : "a number ") + option_range(info));
  }
  return value;
}

template <class Enum>
Enum parse_choice(std::string_view key, std::string_view text) {
  static constexpr auto kNames = kEnumNames<Enum>;
  const auto found = std::find(kNames.begin(), kNames.end(), text);
  if (found == kNames.end()) refuse(key, text, fmt::format("one of {}", fmt::join(kNames, ", ")));
  return static_cast<Enum>(found - kNames.begin());
}

template <class T>
constexpr OptionType type_of() {
  if constexpr (std::is_same_v<T, bool>) {
    return OptionType::boolean;
  } else if constexpr (std::is_enum_v<T>) {
    return OptionType::choice;
  } else {
    return std::is_integral_v<T> ? OptionType::integer : OptionType::real;
  }
}

template <class T>
T parse(const OptionInfo& info, std::string_view text) {
  if constexpr (std::is_same_v<T, bool>) {
    return parse_bool(info.key, text);
  } else if constexpr (std::is_enum_v<T>) {
    return parse_choice<T>(info.key, text);
  } else {
    return parse_number<T>(info, text);
  }
}

template <class T>
std::string print(T value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? "on" : "off";
  } else if constexpr (std::is_enum_v<T>) {
    return std::string(kEnumNames<T>[static_cast<std::size_t>(value)]);
  } else {
    return fmt::format("{}", value);
  }
}

// `member` gives the row's variable in a Settings, const or not.
template <class Member>
Row make_row(OptionInfo info, Member member) {
  using T = std::remove_cvref_t<decltype(member(std::declval<Settings&>()))>;
  info.type = type_of<T>();
  info.default_text = print(member(Settings{}));
  if constexpr (std::is_enum_v<T>) info.choices.assign(kEnumNames<T>.begin(), kEnumNames<T>.end());
  return {info, [info, member](Settings& settings, std::string_view text) { member(settings) = parse<T>(info, text); },
          [member](const Settings& settings) { return print(member(settings)); }};
}

std::vector<Row> make_rows() {
  std::vector<Row> rows;
#define VEL_ROW(group, name, min, max, unit, help)          \
  rows.push_back(make_row(                                  \
      {#group "." #name, {}, unit, help, min, max, {}, {}}, \
      [](auto&& settings) -> auto& { return settings.group.name; }));
#define VEL_GROUP(group, help)
#define VEL_BOOL(group, name, value, help) VEL_ROW(group, name, 0, 0, "", help)
#define VEL_INT(group, name, value, min, max, unit, help) VEL_ROW(group, name, min, max, unit, help)
#define VEL_COUNT(group, name, value, min, max, unit, help) VEL_ROW(group, name, min, max, unit, help)
#define VEL_FLOAT(group, name, value, min, max, unit, help) VEL_ROW(group, name, min, max, unit, help)
#define VEL_ENUM(group, name, Type, value, help) VEL_ROW(group, name, 0, 0, "", help)
#define VEL_END(group)
#include <velarium/options.def>
#undef VEL_ROW
#undef VEL_GROUP
#undef VEL_BOOL
#undef VEL_INT
#undef VEL_COUNT
#undef VEL_FLOAT
#undef VEL_ENUM
#undef VEL_END
  return rows;
}

// Old keys of options that were renamed, which are understood until 0.2.
struct Renamed {
  std::string_view before, now;
};
constexpr std::array kRenamed{Renamed{"lighting.sphere_highlights", "lighting.area_lights"},
                              Renamed{"reference.glow", "reference.emissive_lighting"},
                              Renamed{"sun_shadows.far", "far_shadows.kind"},
                              Renamed{"sun_shadows.far_size", "far_shadows.size"},
                              Renamed{"sun_shadows.reach", "sun_shadows.max_blocker_distance"},
                              Renamed{"sun_shadows.static_size", "far_shadows.static_size"}};

// The key that an option has now, with a warning where it is asked for by an old one.
std::string_view current_key(std::string_view key) {
  const auto* renamed = std::ranges::find(kRenamed, key, &Renamed::before);
  if (renamed == kRenamed.end()) return key;
  log_warning("option {} is named {} now; the old name goes with version 0.2", key, renamed->now);
  return renamed->now;
}

const std::vector<Row>& rows() {
  static const std::vector<Row> kRows = make_rows();
  return kRows;
}

const Row& find_row(std::string_view asked) {
  const std::string_view key = current_key(asked);
  const auto found = std::find_if(rows().begin(), rows().end(), [&](const Row& row) { return row.info.key == key; });
  if (found != rows().end()) return *found;
  std::vector<std::string> keys;
  for (const Row& row : rows()) keys.emplace_back(row.info.key);
  const std::string near = nearest_name(key, keys);
  throw Error(ErrorCode::usage, near.empty() ? fmt::format("'{}' is not an option", key)
                                             : fmt::format("'{}' is not an option; did you mean {}?", key, near));
}

}  // namespace

std::span<const OptionInfo> option_table() {
  static const std::vector<OptionInfo> kTable = [] {
    std::vector<OptionInfo> table;
    for (const Row& row : rows()) table.push_back(row.info);
    return table;
  }();
  return kTable;
}

std::string option_range(const OptionInfo& option) {
  if (option.type == OptionType::boolean) return "on, off";
  if (option.type == OptionType::choice) return fmt::format("{}", fmt::join(option.choices, ", "));
  // Reals were written as floats in the table: as floats they print as they were written.
  std::string text =
      option.type == OptionType::real
          ? fmt::format("from {} to {}", static_cast<float>(option.minimum), static_cast<float>(option.maximum))
          : fmt::format("from {} to {}", static_cast<long long>(option.minimum),
                        static_cast<long long>(option.maximum));
  return option.unit.empty() ? text : fmt::format("{} {}", text, option.unit);
}

std::string_view option_group_help(std::string_view group) {
#define VEL_GROUP(name, help) \
  if (group == #name) return help;
#define VEL_BOOL(group, name, value, help)
#define VEL_INT(group, name, value, min, max, unit, help)
#define VEL_COUNT(group, name, value, min, max, unit, help)
#define VEL_FLOAT(group, name, value, min, max, unit, help)
#define VEL_ENUM(group, name, Type, value, help)
#define VEL_END(group)
#include <velarium/options.def>
#undef VEL_GROUP
#undef VEL_BOOL
#undef VEL_INT
#undef VEL_COUNT
#undef VEL_FLOAT
#undef VEL_ENUM
#undef VEL_END
  return {};
}

void set_option(Settings& settings, std::string_view key, std::string_view value) {
  find_row(key).set(settings, value);
}

std::string get_option(const Settings& settings, std::string_view key) {
  return find_row(key).get(settings);
}

}  // namespace velarium
