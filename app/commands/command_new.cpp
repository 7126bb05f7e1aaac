#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/shared_options/scene_choice.h"
#include "app/commands/start_scene.h"
#include "app/exit_code.h"
#include "app/options/choices.h"
#include "app/own_command.h"
#include "process/input/shell_word.h"

namespace diefill::app {

namespace {

struct NewArguments {
  std::string name, kind = start_kinds().front(), from;
  std::vector<std::string> changes;
};

int write_new(const NewArguments& arguments) {
  const auto scene =
      arguments.from.empty()
          ? write_start_scene(arguments.name, arguments.kind)
          : write_copied_scene(arguments.name, changed_scene(arguments.from, arguments.changes));
  std::printf("wrote %s; run it with: %s run %s\n", scene.c_str(), own_command().c_str(),
              process::shell_word(scene.string()).c_str());
  return kDone;
}

}  // namespace

void add_new(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand("new", "Write a commented scene with tools to start from");
  auto arguments = std::make_shared<NewArguments>();
  command->add_option("NAME", arguments->name, "folder to be made")->required();
  command
      ->add_option("--kind", arguments->kind,
                   "die that the scene fills with coarse grains (default: " + arguments->kind + ")")
      ->check(one_of(start_kinds()));
  auto* from = command
                   ->add_option("--from", arguments->from,
                                "scene to be copied instead, without its comments and variants; it names "
                                "its CAD files where they lie")
                   ->excludes("--kind");
  add_changes(*command, arguments->changes)->needs(from);
  command->footer(
      "Change the scene, or put your own CAD files in place of the tools. Nothing is overwritten.\n"
      "Examples:\n  diefill new my_die\n  diefill new my_ring --kind ring\n"
      "  diefill new slow --from my_die/fill.toml --set 'step.1.velocity = \"0.05 m/s\"'");
  command->callback([arguments, &chosen] { chosen = [arguments] { return write_new(*arguments); }; });
}

}  // namespace diefill::app
