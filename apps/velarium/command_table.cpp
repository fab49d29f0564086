#include "command_table.hpp"

#include <algorithm>
#include <cctype>

namespace velarium::app {
namespace {

FlagRow row_of_flag(const CLI::Option& option) {
  FlagRow row;
  for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
  const bool is_switch = option.get_items_expected_max() == 0;
  if (!is_switch) row.value = option.get_type_name();
  row.help = option.get_description();
  return row;
}

VerbRow row_of_verb(const CLI::App& verb) {
  VerbRow row;
  row.name = verb.get_name();
  row.help = verb.get_description();
  for (const CLI::Option* option : verb.get_options()) {
    if (option->get_group().empty()) continue;  // hidden from --help as well
    if (option->get_positional()) {
      // A verb may take two, of which the help tells in one breath.
      const bool first = row.operand.empty();
      row.operand += (first ? "" : " ") + option->get_name(true);
      row.operand_value = option->get_type_name();
      if (row.operand_value == "TEXT") row.operand_value = row.operand;  // the parser's word for any string
      row.operand_help += (first ? "" : "; ") + option->get_description();
      row.operand_required = option->get_required();
    } else {
      row.flags.push_back(row_of_flag(*option));
    }
  }
  return row;
}

bool is_literal(std::string_view word) {
  return std::all_of(word.begin(), word.end(),
                     [](unsigned char c) { return std::islower(c) || std::isdigit(c) || c == '-'; });
}

}  // namespace

std::vector<VerbRow> command_table(const CLI::App& app) {
  std::vector<VerbRow> table;
  for (const CLI::App* verb : app.get_subcommands({})) table.push_back(row_of_verb(*verb));
  return table;
}

ValueKinds kinds_of_value(std::string_view name) {
  ValueKinds kinds;
  while (!name.empty()) {
    const std::string_view word = name.substr(0, name.find('|'));
    name.remove_prefix(std::min(name.size(), word.size() + 1));
    kinds.file |= word == "FILE";
    kinds.scene |= word == "SCENE";
    kinds.option |= word == "KEY=VALUE";
    if (is_literal(word)) kinds.words.emplace_back(word);
  }
  return kinds;
}

}  // namespace velarium::app
