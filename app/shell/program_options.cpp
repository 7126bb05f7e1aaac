#include "app/shell/program_options.h"

#include <cstdio>

#include "app/options/choices.h"
#include "app/shell/completion.h"
#include "app/shell/manual_page.h"
#include "process/run/assemble.h"
#include "process/run/topics.h"

#ifndef DIEFILL_DRAWING_LIBRARIES
#error "the build names the libraries that draw in DIEFILL_DRAWING_LIBRARIES"
#endif

namespace diefill::app {

namespace {

/// The version on a line of its own, then compiler, instruction set and libraries.
std::string versions_text() {
  const auto topic = process::versions_topic();
  std::string text;
  for (std::size_t k = 0; k < topic.name.size(); ++k)
    text += topic.name[k] + (k == 0 ? " " : ": ") + topic.text[k] + "\n";
  text.pop_back();
  return text + ", " + DIEFILL_DRAWING_LIBRARIES;
}

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
}

}  // namespace

void add_program_options(CLI::App& program) {
  program.set_version_flag("--version", versions_text,
                           "Print version, compiler, instruction set and libraries");
  program
      .add_option_function<std::string>(
          "--completion",
          [&program](const std::string& shell) {
            const auto tree = command_tree(program);
            print(shell == "bash" ? bash_completion(tree) : zsh_completion(tree));
            throw CLI::Success();
          },
          "Print a completion script for this shell")
      ->check(one_of({"bash", "zsh"}));
  program.add_flag_callback(
      "--man",
      [&program] {
        print(manual_page(command_tree(program), process::program_version()));
        throw CLI::Success();
      },
      "Print the manual page (diefill --man | man -l -)");
}

}  // namespace diefill::app
