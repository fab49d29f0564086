#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace velarium::app {

// The command line as plain rows, read from the parser itself: what the manual page and shell completion are made of.

struct FlagRow {
  std::vector<std::string> names;  // "--output", "-o"
  std::string value;               // "FILE|-"; empty: a switch
  std::string help;
};

struct VerbRow {
  std::string name, help;
  std::string operand, operand_help;  // "SCENE" or "PICTURE REFERENCE"; empty: the verb takes none
  std::string operand_value;          // what it may be, as FlagRow::value
  bool operand_required = false;
  std::vector<FlagRow> flags;
};

[[nodiscard]] std::vector<VerbRow> command_table(const CLI::App& app);

// What a value may be, from its name as --help shows it: "FILE|studio|none" takes files, and the words studio and none.
// Words in capitals, and such as WxH or #rrggbb, stand for something; all others are meant literally.
struct ValueKinds {
  std::vector<std::string> words;
  bool file = false, scene = false, option = false;  // FILE, SCENE, KEY=VALUE
};
[[nodiscard]] ValueKinds kinds_of_value(std::string_view name);

}  // namespace velarium::app
