#include "completion_scripts.hpp"

namespace velarium::app {
namespace {

// Bash splits words at = and : as well and replaces only the last part, so the line is split again at blanks, and the
// part before the last = or : is taken off each candidate.
constexpr std::string_view kBash = R"(# Bash completion of velarium; written by `velarium completion bash`.
_velarium() {
  local line=${COMP_LINE:0:COMP_POINT} begun last before word meaning
  local -a words
  read -ra words <<<"$line"
  [[ $line != *[[:blank:]] ]] || words+=("")
  begun=${words[-1]} last=${words[-1]##*[:=]}
  before=${begun%"$last"}
  COMPREPLY=()
  while IFS=$'\t' read -r word meaning; do
    if [[ $word == :files ]]; then
      compopt -o filenames
      mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -f -- "$last")
    else
      COMPREPLY+=("${word#"$before"}")
    fi
  done < <("${words[0]}" completion words -- "${words[@]:1}" 2>/dev/null)
  [[ ${#COMPREPLY[@]} -ne 1 || ${COMPREPLY[0]} != *= ]] || compopt -o nospace
}
complete -F _velarium velarium
)";

// compadd takes the words as they are; _describe would need each colon escaped.
constexpr std::string_view kZsh = R"(#compdef velarium
# Zsh completion of velarium; written by `velarium completion zsh`.
_velarium() {
  local line word files=
  local -a given plain open plain_help open_help
  given=("${(@)words[2,CURRENT]}")
  while IFS= read -r line; do
    word=${line%%$'\t'*}
    case $word in
      :files) files=1 ;;
      *=) open+=("$word") open_help+=("$word  ${line#*$'\t'}") ;;
      *) plain+=("$word") plain_help+=("$word  ${line#*$'\t'}") ;;
    esac
  done < <("${words[1]}" completion words -- "${(@)given}" 2>/dev/null)
  compadd -l -d plain_help -a plain
  compadd -l -S '' -d open_help -a open
  if [[ -n $files ]]; then
    compset -P '*='
    _files
  fi
}
if [[ $funcstack[1] == _velarium ]]; then _velarium "$@"; else compdef _velarium velarium; fi
)";

constexpr std::string_view kFish = R"(# Fish completion of velarium; written by `velarium completion fish`.
function __velarium_candidates
  set -l given (commandline -opc) (commandline -ct)
  for line in ($given[1] completion words -- $given[2..-1] 2>/dev/null)
    if test "$line" = :files
      __fish_complete_path (commandline -ct)
    else
      echo $line
    end
  end
end
complete -c velarium -f -a '(__velarium_candidates)'
)";

}  // namespace

std::string_view completion_script(std::string_view shell) {
  if (shell == "bash") return kBash;
  if (shell == "zsh") return kZsh;
  if (shell == "fish") return kFish;
  return {};
}

}  // namespace velarium::app
