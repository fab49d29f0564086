#include "verbs.hpp"

#include <velarium/error.hpp>
#include <velarium/options.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace velarium::app {
namespace {

std::vector<std::string> flag_names(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

void refuse_unknown(const CLI::App& verb) {
  std::vector<std::string> rest = verb.remaining();
  // The parser leaves the mark after which words are no flags.
  rest.erase(std::remove(rest.begin(), rest.end(), "--"), rest.end());
  if (rest.empty()) return;
  const auto flag =
      std::find_if(rest.begin(), rest.end(), [](const std::string& text) { return text.starts_with('-'); });
  if (flag == rest.end()) throw Error(ErrorCode::usage, fmt::format("'{}' is one argument too many", rest.front()));
  const std::string name = flag->substr(0, flag->find('='));
  const std::string near = nearest_name(name, flag_names(verb));
  throw Error(ErrorCode::usage, near.empty()
                                    ? fmt::format("'{}' is not a flag; see velarium {} --help", name, verb.get_name())
                                    : fmt::format("'{}' is not a flag; did you mean {}?", name, near));
}

}  // namespace

CLI::App& add_verb(CLI::App& app, const std::string& name, const std::string& help, std::function<void()> run) {
  CLI::App& verb = *app.add_subcommand(name, help);
  verb.allow_extras();
  verb.callback([&verb, run = std::move(run)] {
    refuse_unknown(verb);
    run();
  });
  return verb;
}

}  // namespace velarium::app
