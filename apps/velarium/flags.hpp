#pragma once

#include <velarium/settings.hpp>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace velarium::app {

// A flag that configuration files may set as well.
struct Flag {
  std::string names;       // "--output,-o": the first is also the name in the table [render], without its dashes
  std::string value_name;  // "FILE"; empty: a switch
  std::string help;
  std::function<void(const std::string&)> set;  // throws Error(usage) that says what it expected
};

// The flags of a verb. The configuration file is applied first, then the command line from left to right.
class Flags {
 public:
  // Adds `--config` and `-D` to the verb. `settings` is where options are set.
  Flags(CLI::App& verb, Settings& settings);
  Flags(const Flags&) = delete;
  Flags& operator=(const Flags&) = delete;

  void add(Flag flag);
  // A flag that sets one option of the table, which gives its help, range and default; choices also name the value.
  void add_option(const std::string& name, const std::string& key, const std::string& value_name = {});

  // Calls the setters. Throws Error(usage), and what read_config() throws.
  void apply();

 private:
  void apply_config();
  void apply_entry(const struct ConfigEntry& entry);
  [[nodiscard]] const Flag& flag_of_key(const std::string& key) const;

  CLI::App& verb_;
  Settings& settings_;
  std::vector<Flag> flags_;
  std::vector<std::pair<std::size_t, std::string>> given_;  // index of the flag, its value
  std::string config_;
};

// The named option's help with its range and default, as text for people.
[[nodiscard]] std::string option_help(const std::string& key);

}  // namespace velarium::app
