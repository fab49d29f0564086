#include "flags.hpp"

#include "config.hpp"
#include "parse.hpp"

#include <velarium/error.hpp>
#include <velarium/options.hpp>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace velarium::app {
namespace {

std::string first_name(const Flag& flag) {
  return flag.names.substr(0, flag.names.find(','));
}

// Errors of a setter do not know which flag was set.
void set(const Flag& flag, const std::string& value) {
  try {
    flag.set(value);
  } catch (const Error& error) { throw Error(error.code(), fmt::format("{}: {}", first_name(flag), error.what())); }
}

const OptionInfo& find_option(const std::string& key) {
  const auto table = option_table();
  return *std::find_if(table.begin(), table.end(), [&](const OptionInfo& option) { return option.key == key; });
}

}  // namespace

std::string option_help(const std::string& key) {
  const OptionInfo& option = find_option(key);
  return fmt::format("{} [{}; default {}]", option.help, option_range(option), option.default_text);
}

Flags::Flags(CLI::App& verb, Settings& settings) : verb_(verb), settings_(settings) {
  verb_.add_option("--config", config_, "TOML file with options by group, and flags in [render]")->type_name("FILE");
  add({"-D", "KEY=VALUE", "set an option; `velarium options` lists them", [this](const std::string& text) {
         const auto [key, value] = parse_pair(text);
         set_option(settings_, key, value);
       }});
}

void Flags::add(Flag flag) {
  const std::size_t index = flags_.size();
  if (flag.value_name.empty()) {
    verb_
        .add_flag_callback(
            flag.names, [this, index] { given_.emplace_back(index, "on"); }, flag.help)
        ->trigger_on_parse();
  } else {
    const auto give = [this, index](const std::string& value) { given_.emplace_back(index, value); };
    verb_.add_option_function<std::string>(flag.names, give, flag.help)->type_name(flag.value_name)->trigger_on_parse();
  }
  flags_.push_back(std::move(flag));
}

void Flags::add_option(const std::string& name, const std::string& key, const std::string& value_name) {
  const std::string choices = fmt::format("{}", fmt::join(find_option(key).choices, "|"));
  add({name, value_name.empty() ? choices : value_name, option_help(key),
       [this, key](const std::string& value) { set_option(settings_, key, value); }});
}

void Flags::apply() {
  if (!config_.empty()) apply_config();
  for (const auto& [index, value] : given_) set(flags_[index], value);
}

void Flags::apply_config() {
  for (const ConfigEntry& entry : read_config(config_)) {
    try {
      apply_entry(entry);
    } catch (const Error& error) { throw Error(error.code(), config_, at_place(entry, error.what())); }
  }
}

void Flags::apply_entry(const ConfigEntry& entry) {
  if (entry.table != "render") {
    const std::string key = entry.table + "." + entry.key;
    for (const std::string& value : entry.values) set_option(settings_, key, value);
    return;
  }
  const Flag& flag = flag_of_key(entry.key);
  const bool is_switch = flag.value_name.empty();
  for (const std::string& value : entry.values) {
    if (is_switch && value != "on" && value != "off") {
      throw Error(ErrorCode::usage, fmt::format("{} is true or false, not '{}'", entry.key, value));
    }
    if (!is_switch || value == "on") set(flag, value);
  }
}

const Flag& Flags::flag_of_key(const std::string& key) const {
  std::vector<std::string> known;
  for (const Flag& flag : flags_) {
    if (!flag.names.starts_with("--")) continue;
    if (first_name(flag) == "--" + key) return flag;
    known.push_back(first_name(flag).substr(2));
  }
  const std::string near = nearest_name(key, known);
  throw Error(ErrorCode::usage, near.empty() ? fmt::format("[render] has no '{}'", key)
                                             : fmt::format("[render] has no '{}'; did you mean {}?", key, near));
}

}  // namespace velarium::app
