#pragma once

#include <velarium/settings.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace velarium {

enum class OptionType { boolean, integer, real, choice };

// One row of options.def, for programs that list, document or edit options.
struct OptionInfo {
  std::string_view key;  // "lighting.model"
  OptionType type;
  std::string_view unit;    // "" where it has none
  std::string_view help;    // one sentence
  double minimum, maximum;  // of integers and reals
  std::vector<std::string_view> choices;
  std::string default_text;
};

// All options, in the order of the table.
[[nodiscard]] std::span<const OptionInfo> option_table();

// What values an option takes: "from 1 to 65536 frames", "gltf, ryse" or "on, off".
[[nodiscard]] std::string option_range(const OptionInfo& option);

// One line about a group ("lighting"), or an empty view.
[[nodiscard]] std::string_view option_group_help(std::string_view group);

// Sets one option from text: "on/off/true/false/1/0", a number, or a choice.
// Throws Error(usage) that names the key, the range or the choices, and the nearest known key.
void set_option(Settings& settings, std::string_view key, std::string_view value);

// The present value as text that set_option reads back.
[[nodiscard]] std::string get_option(const Settings& settings, std::string_view key);

// The member of `known` that a mistyped `word` most likely meant, or "" where nothing is near.
[[nodiscard]] std::string nearest_name(std::string_view word, std::span<const std::string> known);

}  // namespace velarium
