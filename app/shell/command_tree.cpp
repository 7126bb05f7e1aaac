#include "app/shell/command_tree.h"

namespace diefill::app {

namespace {

/// The words of "TEXT:{coarse,medium}"; none where the type lists no words.
std::vector<std::string> choices_in(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos || close < open) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

OptionText option_text(const CLI::Option& option) {
  OptionText text;
  for (const auto& name : option.get_snames()) text.names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) text.names.push_back("--" + name);
  text.positional = text.names.empty();
  if (text.positional) text.names = {option.get_single_name()};
  text.description = option.get_description();
  if (option.get_items_expected_max() == 0) return text;
  const std::string type = option.get_type_name();
  text.value = type.substr(0, type.find(':'));
  text.choices = choices_in(type);
  return text;
}

CommandText command_text(const CLI::App& command, std::vector<std::string> words) {
  CommandText text;
  text.description = command.get_description();
  text.footer = command.get_footer();
  for (const CLI::Option* option : command.get_options())
    if (!option->get_group().empty()) text.options.push_back(option_text(*option));
  for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; })) {
    if (below->get_group().empty()) continue;
    auto path = words;
    path.push_back(below->get_name());
    text.commands.push_back(command_text(*below, std::move(path)));
  }
  text.words = std::move(words);
  return text;
}

}  // namespace

std::string CommandText::path() const {
  std::string path;
  for (const auto& word : words) path += (path.empty() ? "" : " ") + word;
  return path;
}

CommandText command_tree(const CLI::App& program) {
  return command_text(program, {});
}

std::vector<const CommandText*> all_commands(const CommandText& command) {
  std::vector<const CommandText*> all = {&command};
  for (const auto& below : command.commands)
    for (const auto* one : all_commands(below)) all.push_back(one);
  return all;
}

}  // namespace diefill::app
