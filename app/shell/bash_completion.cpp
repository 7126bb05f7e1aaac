#include "app/shell/completion.h"

namespace diefill::app {

namespace {

constexpr const char* kOpening = R"(# Completion of diefill for bash, written by: diefill --completion bash
_diefill() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command="" longer="" choices="" k
  COMPREPLY=()
  for ((k = 1; k < COMP_CWORD; k++)); do
    longer="$command${command:+ }${COMP_WORDS[k]}"
    case "$longer" in
)";

// Options with a value of any kind complete to files: most of them are files. A word in which blanks are
// escaped is left to the shell's own completion.
constexpr const char* kClosing = R"(  esac
  if [[ $choices == "<file>" || -z $choices ]]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
    [[ ${#COMPREPLY[@]} -gt 0 ]] || compopt -o default 2>/dev/null
  else
    COMPREPLY=($(compgen -W "$choices" -- "$word"))
  fi
}
complete -o filenames -F _diefill diefill
)";

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// "run:--out", for a case of command and previous word.
std::string after_option(const CommandText& command, const OptionText& option) {
  std::string pattern;
  for (const auto& name : option.names)
    pattern += (pattern.empty() ? "\"" : " | \"") + command.path() + ":" + name + '"';
  return pattern;
}

/// What may follow the command itself: its commands, or the choices of its first argument.
std::vector<std::string> next_words(const CommandText& command) {
  std::vector<std::string> words;
  for (const auto& below : command.commands) words.push_back(below.words.back());
  if (!words.empty()) return words;
  for (const auto& option : command.options)
    if (option.positional) return option.choices;
  return {};
}

std::string cases_of_values(const std::vector<const CommandText*>& all) {
  std::string text;
  for (const auto* command : all)
    for (const auto& option : command->options)
      if (!option.positional && !option.value.empty())
        text += "    " + after_option(*command, option) + ") choices=\"" +
                (option.choices.empty() ? "<file>" : joined(option.choices)) + "\" ;;\n";
  return text;
}

std::string cases_of_words(const std::vector<const CommandText*>& all) {
  std::string text;
  for (const auto* command : all) {
    std::vector<std::string> options;
    for (const auto& option : command->options)
      if (!option.positional) options.insert(options.end(), option.names.begin(), option.names.end());
    text += "    \"" + command->path() + ":-\"*) choices=\"" + joined(options) + "\" ;;\n";
    text += "    \"" + command->path() + ":\"*) choices=\"" + joined(next_words(*command)) + "\" ;;\n";
  }
  return text;
}

}  // namespace

std::string bash_completion(const CommandText& program) {
  const auto all = all_commands(program);
  std::string known;
  for (const auto* command : all)
    if (!command->words.empty()) known += (known.empty() ? "" : " | ") + ('"' + command->path() + '"');
  return kOpening + ("      " + known) +
         ") command=$longer ;;\n    esac\n  done\n  case \"$command:$previous\" in\n" + cases_of_values(all) +
         "  esac\n  [[ -n $choices ]] || case \"$command:$word\" in\n" + cases_of_words(all) + kClosing;
}

}  // namespace diefill::app
