#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace velarium::app {

// One `key = value` of a configuration file.
struct ConfigEntry {
  std::string table, key;
  std::vector<std::string> values;  // a list of texts is several; of numbers one, "1,2,3"; true is "on"
  unsigned line = 0, column = 0;    // of the value, from 1
};

// A TOML file whose tables are the groups of options, and [render] for the flags of the command line.
// Throws Error(input_missing), or Error(input_invalid) with line and column.
[[nodiscard]] std::vector<ConfigEntry> read_config(const std::filesystem::path& file);

// "line 3, column 7: reason"
[[nodiscard]] std::string at_place(const ConfigEntry& entry, const std::string& reason);

}  // namespace velarium::app
