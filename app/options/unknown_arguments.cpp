#include "app/options/unknown_arguments.h"

#include <algorithm>

#include "app/options/choices.h"
#include "process/input/nearest_key.h"

namespace diefill::app {
namespace {

using Words = std::vector<std::string>;

Words names_of_commands(const CLI::App& command) {
  Words names;
  for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; }))
    if (!below->get_group().empty()) names.push_back(below->get_name());
  return names;
}

/// Long names without dashes.
Words names_of_options(const CLI::App& command) {
  Words names;
  for (const CLI::Option* option : command.get_options())
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  return names;
}

std::string arguments_of(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional()) text += (text.empty() ? "" : " ") + option->get_name(true);
  return text;
}

/// "--theads=2" and "-theads" as "theads".
std::string without_dashes(const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  return name.substr(std::min(name.size(), name.find_first_not_of('-')));
}

std::string about_option(const CLI::App& command, const std::string& word) {
  const Words names = names_of_options(command);
  std::string text = "unknown option \"" + word.substr(0, word.find('=')) + "\"";
  if (const auto nearest = process::nearest_key(without_dashes(word), names))
    return text + "; did you mean --" + *nearest + "?";
  text += " (allowed:";
  for (const auto& name : names) text += " --" + name;
  return text + ")";
}

std::string about_argument(const CLI::App& command, const std::string& word) {
  const std::string arguments = arguments_of(command);
  const std::string takes = arguments.empty() ? "it takes options only" : "its arguments are " + arguments;
  return "found \"" + word + "\", which is one argument too many; " + takes;
}

std::string about(const CLI::App& command, bool is_lab, const Words& extra) {
  const auto option =
      std::find_if(extra.begin(), extra.end(), [](const auto& word) { return word.starts_with('-'); });
  const Words commands = names_of_commands(command);
  if (!commands.empty() && !extra.front().starts_with('-'))
    return (is_lab ? "unknown experiment: " : "unknown command: ") + unknown_name(extra.front(), commands);
  if (option != extra.end()) return about_option(command, *option);
  return about_argument(command, extra.front());
}

}  // namespace

std::optional<std::string> unknown_argument(const CLI::App& program) {
  std::string path = "diefill";
  const CLI::App* command = &program;
  while (true) {
    const Words extra = command->remaining();
    if (!extra.empty()) return path + ": " + about(*command, command != &program, extra);
    const auto below = command->get_subcommands();
    if (below.empty()) return std::nullopt;
    command = below.front();
    path += ' ' + command->get_name();
  }
}

}  // namespace diefill::app
