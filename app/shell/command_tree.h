// The program's commands and options as plain data, read from its command line parser: what the manual page
// and shell completion are written from, so that they list what the program has.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace diefill::app {

/// An option, flag or positional argument.
struct OptionText {
  std::vector<std::string> names;    ///< with dashes; a positional argument has one name without
  std::string value;                 ///< such as "TEXT"; empty for flags
  std::vector<std::string> choices;  ///< allowed values; empty: any
  std::string description;
  bool positional = false;
};

/// A command with its options and the commands below it.
struct CommandText {
  std::vector<std::string> words;  ///< such as {"lab", "silo"}; empty for the program itself
  std::string description, footer;
  std::vector<OptionText> options;
  std::vector<CommandText> commands;

  /// "lab silo".
  std::string path() const;
};

/// All commands of `program`, hidden ones left out.
CommandText command_tree(const CLI::App& program);

/// `command` and all commands below it, a command before those below it.
std::vector<const CommandText*> all_commands(const CommandText& command);

}  // namespace diefill::app
