#include "console.hpp"
#include "interrupt.hpp"
#include "verbs.hpp"

#include <velarium/error.hpp>
#include <velarium/options.hpp>
#include <velarium/version.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

namespace velarium::app {
namespace {

int code(ErrorCode error) {
  return static_cast<int>(error);
}

std::vector<std::string> verb_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands({})) names.push_back(verb->get_name());
  return names;
}

// A word that is no file and nearly a verb is a mistyped verb, not a scene.
void refuse_mistyped_verb(const std::string& word, const std::vector<std::string>& verbs) {
  const bool plain = std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isalpha(c) || c == '-'; });
  if (!plain || word.starts_with('-') || std::filesystem::exists(word)) return;
  const std::string near = nearest_name(word, verbs);
  if (near.empty()) return;
  throw Error(ErrorCode::usage, fmt::format("'{}' is neither a verb nor a file; did you mean {}?", word, near));
}

// `velarium SCENE ...` means `velarium render SCENE ...`; no argument at all asks for help.
std::vector<std::string> with_verb(std::vector<std::string> arguments, const CLI::App& app) {
  if (arguments.empty()) return {"--help"};
  const std::string& first = arguments.front();
  const std::vector<std::string> verbs = verb_names(app);
  const bool for_program = first == "--help" || first == "-h" || first == "--version";
  if (for_program || std::find(verbs.begin(), verbs.end(), first) != verbs.end()) return arguments;
  refuse_mistyped_verb(first, verbs);
  arguments.insert(arguments.begin(), "render");
  return arguments;
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("glTF scenes in, physically based pictures out", "velarium");
  app.set_version_flag("--version", fmt::format("velarium {}", kVersion));
  app.footer(
      "velarium VERB --help tells more. Exit codes: 0 done, 1 pictures differ, 2 usage, 3 input missing,\n"
      "4 input invalid, 5 unsupported, 6 no usable device, 7 output not written, 70 defect, 75 try again,\n"
      "130 and 143 interrupted.");
  app.require_subcommand(0, 1);
  for (const auto add :
       {add_render, add_reference, add_info, add_devices, add_bench, add_compare, add_options, add_completion})
    add(app);

  std::vector<std::string> arguments = with_verb({argv + 1, argv + argc}, app);
  const std::string verb = arguments.front();
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::RequiredError& error) {
    throw Error(ErrorCode::usage, fmt::format("{}; velarium {} --help tells what", error.what(), verb));
  } catch (const CLI::Error& error) { throw Error(ErrorCode::usage, error.what()); }
  return 0;
}

int run(int argc, char** argv) {
  watch_signals();
  set_verbosity(Verbosity::normal);
  try {
    return parse_and_run(argc, argv);
  } catch (const Interrupted& interrupted) {
    say_error(fmt::format("interrupted; {}", interrupted.outcome));
    return exit_code_of_signal(interrupted.signal);
  } catch (const Error& error) {
    say_error(error.what());
    return code(error.code());
  } catch (const std::bad_alloc&) {
    say_error("out of memory");
    return code(ErrorCode::temporary);
  } catch (const std::exception& error) {
    say_error(fmt::format("{} (this is a defect of Velarium; please report it)", error.what()));
    return code(ErrorCode::internal);
  }
}

}  // namespace
}  // namespace velarium::app

int main(int argc, char** argv) {
  return velarium::app::run(argc, argv);
}
