#include "man_page.hpp"

#include "command_table.hpp"

#include <velarium/options.hpp>
#include <velarium/version.hpp>

#include <fmt/core.h>

namespace velarium::app {
namespace {

// Text that roff shows as it is: hyphens stay hyphens when copied, and no line becomes a request.
std::string roff(std::string_view text) {
  std::string escaped;
  bool line_starts = true;
  for (const char c : text) {
    if (line_starts && (c == '.' || c == '\'')) escaped += "\\&";
    line_starts = c == '\n';
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else if (c == '`') {
      escaped += "\\(ga";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string heading(std::string_view text) {
  return fmt::format(".SH {}\n", text);
}

// An indented paragraph under its tag.
std::string entry(const std::string& tag, std::string_view text) {
  return fmt::format(".TP\n{}\n{}\n", tag, roff(text));
}

std::string tag_of_flag(const FlagRow& flag) {
  std::string tag;
  for (const std::string& name : flag.names) tag += fmt::format("{}\\fB{}\\fR", tag.empty() ? "" : ", ", roff(name));
  if (!flag.value.empty()) tag += fmt::format(" \\fI{}\\fR", roff(flag.value));
  return tag;
}

std::string synopsis(const VerbRow& verb) {
  std::string line = fmt::format(".br\n\\fBvelarium {}\\fR", roff(verb.name));
  const std::string operand = fmt::format("\\fI{}\\fR", verb.operand);
  if (!verb.operand.empty()) line += verb.operand_required ? " " + operand : " [" + operand + "]";
  return line + (verb.flags.empty() ? "\n" : " [\\fIflags\\fR]\n");
}

std::string section_of_verb(const VerbRow& verb) {
  std::string text = fmt::format(".SS velarium {}\n{}.\n", roff(verb.name), roff(verb.help));
  if (!verb.operand.empty()) text += entry(fmt::format("\\fI{}\\fR", verb.operand), verb.operand_help);
  for (const FlagRow& flag : verb.flags) text += entry(tag_of_flag(flag), flag.help);
  return text;
}

std::string table_of_options() {
  std::string text = heading("OPTIONS") +
                     "Each is set by \\fB\\-D\\fR \\fIKEY=VALUE\\fR or, in a file that \\fB\\-\\-config\\fR names, by "
                     "\\fIname = value\\fR in the table of its group.\n";
  std::string_view group;
  for (const OptionInfo& option : option_table()) {
    const std::string_view its_group = option.key.substr(0, option.key.find('.'));
    if (its_group != group) {
      group = its_group;
      text += fmt::format(".SS {}: {}\n", roff(group), roff(option_group_help(group)));
    }
    text += entry(fmt::format("\\fB{}\\fR", roff(option.key)),
                  fmt::format("{} [{}; default {}]", option.help, option_range(option), option.default_text));
  }
  return text;
}

}  // namespace

std::string man_page(const CLI::App& app) {
  const std::vector<VerbRow> verbs = command_table(app);
  std::string text = fmt::format(".TH VELARIUM 1 \"\" \"velarium {}\" \"User Commands\"\n", kVersion);
  text += heading("NAME") + fmt::format("velarium \\- {}\n", roff(app.get_description()));
  text += heading("SYNOPSIS") + "\\fBvelarium\\fR \\fISCENE\\fR [\\fIflags\\fR]\n";
  for (const VerbRow& verb : verbs) text += synopsis(verb);
  text += heading("DESCRIPTION") +
          "A scene alone is drawn, as \\fBvelarium render\\fR does. No display is needed, and no GPU where a software "
          "driver of Vulkan is installed.\n";
  text += heading("VERBS");
  for (const VerbRow& verb : verbs) text += section_of_verb(verb);
  text += table_of_options();
  text += heading("EXIT STATUS") + roff(app.get_footer()) + "\n";
  return text;
}

}  // namespace velarium::app
