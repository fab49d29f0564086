#include "verbs.hpp"

#include "command_table.hpp"
#include "completion_scripts.hpp"
#include "console.hpp"

#include <velarium/error.hpp>
#include <velarium/options.hpp>
#include <velarium/scene.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <span>

namespace velarium::app {
namespace {

// What may stand where the cursor is: one line a candidate, "WORD<tab>what it means", and kFiles for names of files.
// The shells' scripts read exactly this.
constexpr const char* kFiles = ":files\n";

class Candidates {
 public:
  explicit Candidates(std::string begun) : begun_(std::move(begun)) {}

  void add(std::string_view word, std::string_view meaning) {
    if (word.starts_with(begun_)) text_ += fmt::format("{}\t{}\n", word, meaning);
  }
  void add_files() { text_ += kFiles; }
  [[nodiscard]] const std::string& begun() const { return begun_; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string begun_, text_;
};

void add_scenes(Candidates& candidates) {
  for (const std::string& name : Scene::builtin_names()) candidates.add("builtin:" + name, "a built-in scene");
  candidates.add_files();
}

// Keys, and after "KEY=" the values of that key.
void add_options_table(Candidates& candidates) {
  const std::string& begun = candidates.begun();
  const bool wants_value = begun.find('=') != std::string::npos;
  for (const OptionInfo& option : option_table()) {
    const std::string start = fmt::format("{}=", option.key);
    if (!wants_value) candidates.add(start, option.help);
    if (!wants_value || !begun.starts_with(start)) continue;
    for (const std::string_view choice : option.choices) candidates.add(start + std::string(choice), option.help);
    if (option.type == OptionType::boolean) {
      candidates.add(start + "on", option.help);
      candidates.add(start + "off", option.help);
    }
  }
}

void add_values(const std::string& value_name, Candidates& candidates) {
  const ValueKinds kinds = kinds_of_value(value_name);
  for (const std::string& word : kinds.words) candidates.add(word, "");
  if (kinds.scene) add_scenes(candidates);
  if (kinds.option) add_options_table(candidates);
  if (kinds.file) candidates.add_files();
}

const FlagRow* find_flag(const VerbRow& verb, const std::string& name) {
  const auto has_name = [&](const FlagRow& flag) {
    return std::find(flag.names.begin(), flag.names.end(), name) != flag.names.end();
  };
  const auto found = std::find_if(verb.flags.begin(), verb.flags.end(), has_name);
  return found == verb.flags.end() ? nullptr : &*found;
}

// "--env=stu": the part after the sign, with the flag in front again.
std::string values_of_joined_flag(const VerbRow& verb, const std::string& word) {
  const std::size_t sign = word.find('=');
  const std::string name = word.substr(0, sign);
  const FlagRow* flag = find_flag(verb, name);
  if (flag == nullptr) return {};
  Candidates values(word.substr(sign + 1));
  add_values(flag->value, values);
  std::string text;
  std::string_view lines = values.text();
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n') + 1);
    lines.remove_prefix(line.size());
    text += line == kFiles ? std::string(line) : fmt::format("{}={}", name, line);
  }
  return text;
}

std::string complete_in_verb(const VerbRow& verb, std::span<const std::string> words) {
  const std::string& last = words.back();
  const FlagRow* before = words.size() > 1 ? find_flag(verb, words[words.size() - 2]) : nullptr;
  Candidates candidates(last);
  if (before != nullptr && !before->value.empty()) {
    add_values(before->value, candidates);
    return candidates.text();
  }
  if (last.starts_with("--") && last.find('=') != std::string::npos) return values_of_joined_flag(verb, last);
  if (last.starts_with('-')) {
    for (const FlagRow& flag : verb.flags) {
      for (const std::string& name : flag.names) candidates.add(name, flag.help);
    }
  } else {
    add_values(verb.operand_value, candidates);
  }
  return candidates.text();
}

// `words` are those after the program's name, up to the cursor; the last is the begun one, perhaps empty.
std::string complete(const std::vector<VerbRow>& table, const std::vector<std::string>& words) {
  const auto named = [](const std::string& name) { return [&](const VerbRow& verb) { return verb.name == name; }; };
  const auto verb = std::find_if(table.begin(), table.end(), named(words.front()));
  if (words.size() > 1 && verb != table.end()) return complete_in_verb(*verb, std::span(words).subspan(1));
  // The program takes a scene in the place of a verb, and then draws it.
  const auto render = std::find_if(table.begin(), table.end(), named("render"));
  std::string text = complete_in_verb(*render, words);
  if (words.size() > 1 || words.front().starts_with('-')) return text;
  Candidates verbs(words.front());
  for (const VerbRow& row : table) verbs.add(row.name, row.help);
  return verbs.text() + text;
}

struct Completion {
  std::string shell;
  std::vector<std::string> words;

  void run(const CLI::App& app) const {
    if (shell == "words") {
      print(complete(command_table(app), words.empty() ? std::vector<std::string>{""} : words));
      return;
    }
    const std::string_view script = completion_script(shell);
    if (script.empty())
      throw Error(ErrorCode::usage, fmt::format("no completion for '{}'; there are bash, zsh and fish", shell));
    print(script);
  }
};

}  // namespace

void add_completion(CLI::App& app) {
  const auto completion = std::make_shared<Completion>();
  CLI::App& verb = add_verb(app, "completion", "print a script that makes a shell complete velarium's arguments",
                            [completion, &app] { completion->run(app); });
  verb.add_option("SHELL", completion->shell, "which shell; installed packages bring these scripts along")
      ->type_name("bash|zsh|fish")
      ->required();
  verb.add_option("WORDS", completion->words)->group("");  // what the scripts ask: `completion words -- render --t`
}

}  // namespace velarium::app
