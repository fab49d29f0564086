#include "verbs.hpp"

#include "console.hpp"
#include "man_page.hpp"

#include <velarium/options.hpp>

#include <fmt/core.h>

#include <memory>

namespace velarium::app {
namespace {

// A bar would end a cell of a Markdown table.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return escaped;
}

std::string options_as_markdown() {
  std::string text =
      "# Options\n\nWritten by `velarium options` from `include/velarium/options.def`. Each is set by `-D KEY=VALUE` "
      "or, "
      "in a file that `--config` names, by `name = value` in the table of its group.\n";
  std::string_view group;
  for (const OptionInfo& option : option_table()) {
    const std::string_view its_group = option.key.substr(0, option.key.find('.'));
    if (its_group != group) {
      group = its_group;
      text += fmt::format("\n## {}: {}\n\n| key | values | default | what it does |\n|---|---|---|---|\n", group,
                          option_group_help(group));
    }
    text += fmt::format("| `{}` | {} | {} | {} |\n", option.key, cell(option_range(option)), option.default_text,
                        cell(option.help));
  }
  return text;
}

}  // namespace

void add_options(CLI::App& app) {
  const auto man = std::make_shared<bool>(false);
  CLI::App& verb = add_verb(app, "options", "print the table of options, as Markdown",
                            [man, &app] { print(*man ? man_page(app) : options_as_markdown()); });
  verb.add_flag("--man", *man, "print the manual page of the whole program instead, for man(1)");
}

}  // namespace velarium::app
