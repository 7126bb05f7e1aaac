#include "app/program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "app/commands/commands.h"
#include "app/exit_code.h"
#include "app/options/empty_arguments.h"
#include "app/options/unknown_arguments.h"
#include "app/output.h"
#include "app/shell/program_options.h"
#include "process/input/shown_value.h"

namespace diefill::app {

namespace {

/// What CLI11 says of arguments; where it gives only counts, what to do.
std::string argument_message(const CLI::Error& error) {
  const std::string message = error.what();
  const std::string option = message.substr(0, message.find(": "));
  if (error.get_name() != "ArgumentMismatch") return message;
  if (message.find(": At Most 1 required") != std::string::npos)
    return option + ": found more than one value, allowed: one; give it once";
  if (message.ends_with(" missing")) return option + ": found no value; write one after it";
  return message;
}

/// The error in the command-line arguments, on one line. An unknown argument comes first, because other
/// errors may follow from it.
std::string in_one_line(const CLI::App* program, const CLI::Error& error) {
  constexpr std::size_t kLongest = 1200;
  std::string command = "diefill";
  for (const CLI::App* chosen = program; !chosen->get_subcommands().empty();) {
    chosen = chosen->get_subcommands().front();
    command += ' ' + chosen->get_name();
  }
  const std::string wrong = unknown_argument(*program).value_or("diefill: " + argument_message(error));
  return process::one_line(process::with_short_words(wrong), kLongest) + "; " + command +
         " --help lists the options\n";
}

/// Whether an argument is empty; if so, prints a message to standard error.
bool refuse_empty_word(int argc, char** argv) {
  const auto wrong = empty_argument({argv + std::min(argc, 1), argv + argc});
  if (wrong)
    std::fprintf(stderr, "diefill: %s\n", process::one_line(process::with_short_words(*wrong), 600).c_str());
  return wrong.has_value();
}

}  // namespace

int run_program(int argc, char** argv) {
  if (refuse_empty_word(argc, argv)) return kBadInput;
  CLI::App program(
      "diefill predicts how powder fills a die: density maps from CAD tools and a short scene file.");
  program.require_subcommand(1);
  program.failure_message(in_one_line);
  program.footer(
      "Examples:\n"
      "  diefill new my_die                                   write a scene with tools to start from\n"
      "  diefill check sample_tools/narrow_ring/fill.toml     check tools and scene without simulating\n"
      "  diefill plan sample_tools/narrow_ring/fill.toml      predict size, memory and wall time\n"
      "  diefill powders                                      list the built-in powders\n"
      "  diefill run sample_tools/narrow_ring/fill.toml       simulate, write maps and report\n"
      "  diefill compare sample_tools/narrow_ring/strategies.toml  compare filling strategies\n"
      "  diefill map out/narrow_ring --averaging-width '1 mm' redraw the maps with wider averaging\n"
      "  diefill info out/narrow_ring                         print the contents of results\n"
      "  diefill bench clumps                                 measure the speed of this machine");
  Action chosen;
  add_commands(program, chosen);
  add_program_options(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (program.exit(error) != 0) return kBadInput;
    return flush_standard_output() ? kDone : kFailed;
  }
  const int code = guarded(chosen);
  if (!flush_standard_output() && code == kDone) return kFailed;
  return code;
}

}  // namespace diefill::app
