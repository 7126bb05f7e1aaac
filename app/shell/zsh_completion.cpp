#include "app/shell/completion.h"

namespace diefill::app {

namespace {

/// `text` for a place in single quotes between brackets or after a colon.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\'')
      safe += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      safe += std::string("\\") + c;
    else
      safe += c == '\n' ? ' ' : c;
  }
  return safe;
}

/// Such as ":TEXT:(coarse medium)", what may be given as the option's value.
std::string action_of(const OptionText& option) {
  if (option.value.empty()) return "";
  std::string choices;
  for (const auto& choice : option.choices) choices += (choices.empty() ? "" : " ") + choice;
  return ":" + escaped(option.value) + ":" + (choices.empty() ? "_files" : "(" + escaped(choices) + ")");
}

std::string specification(const OptionText& option) {
  if (option.positional) {
    const std::string action = action_of(option);
    return "    '*:" + escaped(option.names.front()) + action.substr(action.rfind(':')) + "'";
  }
  std::string text;
  for (const auto& name : option.names)
    text += (text.empty() ? "    '" : " \\\n    '") + name + '[' + escaped(option.description) + ']' +
            action_of(option) + '\'';
  return text;
}

std::string function_name(const CommandText& command) {
  std::string name = "_diefill";
  for (const auto& word : command.words) name += '_' + word;
  return name;
}

/// The list of the commands below, and the call of the chosen one's function.
std::string choice_of_command(const CommandText& command) {
  std::string list, cases;
  for (const auto& below : command.commands) {
    list += "      '" + escaped(below.words.back()) + ":" + escaped(below.description) + "'\n";
    cases += "        " + below.words.back() + ") " + function_name(below) + " ;;\n";
  }
  return "  case $state in\n    command)\n      local -a commands=(\n" + list +
         "      )\n      _describe command commands ;;\n    rest)\n      case $line[1] in\n" + cases +
         "      esac ;;\n  esac\n";
}

std::string function_of(const CommandText& command) {
  std::string text = function_name(command) + "() {\n";
  if (!command.commands.empty()) text += "  local state line\n  typeset -A opt_args\n";
  text += command.commands.empty() ? "  _arguments" : "  _arguments -C";
  for (const auto& option : command.options)
    if (!option.positional || command.commands.empty()) text += " \\\n" + specification(option);
  if (!command.commands.empty()) text += " \\\n    '1: :->command' \\\n    '*:: :->rest'";
  text += "\n";
  if (!command.commands.empty()) text += choice_of_command(command);
  return text + "}\n\n";
}

}  // namespace

std::string zsh_completion(const CommandText& program) {
  std::string text =
      "#compdef diefill\n# Completion of diefill for zsh, written by: diefill --completion zsh\n\n";
  for (const auto* command : all_commands(program)) text += function_of(*command);
  return text + "_diefill \"$@\"\n";
}

}  // namespace diefill::app
