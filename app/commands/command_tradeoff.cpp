#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>

#include "app/backup_notes.h"
#include "app/commands/commands.h"
#include "app/commands/live_jobs.h"
#include "app/commands/tradeoff_targets.h"
#include "app/exit_code.h"
#include "app/options/numbers.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "app/stop_signals.h"
#include "app/tables/tradeoff_table.h"
#include "process/compare/backups.h"
#include "process/input/shell_word.h"
#include "process/results/studies/tradeoff.h"
#include "process/scene/folder_names.h"
#include "process/setup/predicted_work.h"
#include "process/tradeoff/trade_off.h"
#include "render/charts/tradeoff_chart.h"

namespace diefill::app {

namespace {

struct TradeoffArguments {
  std::string scene, out, reference;
  std::vector<std::string> vary, targets;
  double budget = 0, tolerance = 2;
  int seeds = 2, jobs = 1, threads = 1;
  bool variants = false, quiet = false;
};

/// The command as one would type it again.
std::string command_text(const TradeoffArguments& arguments) {
  std::string words = "diefill tradeoff " + arguments.scene;
  for (const auto& vary : arguments.vary) words += " --vary " + process::shell_word(vary);
  if (arguments.variants) words += " --variants";
  for (const auto& target : arguments.targets) words += " --target " + process::shell_word(target);
  if (!arguments.reference.empty()) words += " --reference " + process::shell_word(arguments.reference);
  char text[100];
  std::snprintf(text, sizeof text, " --seeds %d --tolerance %g", arguments.seeds, arguments.tolerance);
  words += text;
  if (arguments.budget > 0) {
    std::snprintf(text, sizeof text, " --budget %g", arguments.budget);
    words += text;
  }
  return words;
}

process::TradeoffOptions options_of(const TradeoffArguments& arguments, const process::Scene& scene) {
  process::TradeoffOptions options;
  options.directory = arguments.out.empty() ? default_directory(arguments.scene, "_tradeoff")
                                            : std::filesystem::path(arguments.out);
  options.targets = read_targets(arguments.targets, scene);
  options.seeds = arguments.seeds;
  options.tolerance = 0.01 * arguments.tolerance;
  options.reference = arguments.reference;
  options.variants = arguments.variants;
  options.command = command_text(arguments);
  options.on_note = print_note;
  options.jobs.program = std::filesystem::read_symlink("/proc/self/exe");
  options.jobs.at_once = arguments.jobs;
  options.jobs.threads = arguments.threads;
  options.jobs.pictures = false;
  options.jobs.show_progress = !arguments.quiet;
  if (arguments.budget > 0) options.jobs.cpu_seconds = 60 * arguments.budget;
  return options;
}

/// File names of the parameters' charts.
std::vector<std::string> chart_names(const results::Tradeoff& tradeoff) {
  std::vector<std::string> names;
  for (const auto& parameter : tradeoff.parameters) names.push_back(parameter.name);
  names = process::folder_names(names);
  for (std::string& name : names) name = "parameter_" + name + ".png";
  return names;
}

bool any_result(const results::Tradeoff& tradeoff) {
  return std::any_of(tradeoff.points.begin(), tradeoff.points.end(),
                     [](const auto& point) { return std::isfinite(point.error); });
}

std::vector<std::string> write_all(const std::filesystem::path& directory,
                                   const results::Tradeoff& tradeoff) {
  std::vector<std::string> written = {"tradeoff.csv", "tradeoff.json"};
  write_output([&] {
    note_moved_results(process::back_up_earlier_tables(directory, tradeoff));
    results::write_tradeoff(directory, tradeoff);
    if (!any_result(tradeoff)) return;
    set_up_drawing();
    render::draw_tradeoff(directory / "tradeoff.png", tradeoff);
    written.emplace_back("tradeoff.png");
    const auto charts = chart_names(tradeoff);
    for (std::size_t k = 0; k < charts.size(); ++k) {
      render::draw_parameter(directory / charts[k], tradeoff, tradeoff.parameters[k]);
      written.push_back(charts[k]);
    }
  });
  return written;
}

int trade_off(const TradeoffArguments& arguments) {
  const auto scene = process::read_scene(arguments.scene);
  process::refuse_excessive_work(scene);
  auto options = options_of(arguments, scene);
  require_directory(options.directory);
  std::vector<process::ParameterValues> parameters;
  for (const auto& text : arguments.vary) parameters.push_back(process::read_vary(text));
  auto plan = process::plan_tradeoff(scene, parameters, options);
  const OutputDirectory output(options.directory, {"tools"});
  options.jobs.stop = &install_stop_handlers();
  options.jobs.watch = live_jobs(options.directory, "Trade-off: " + scene.title);
  const auto tradeoff = process::trade_off(scene, std::move(plan), options);
  const auto written = write_all(options.directory, tradeoff);
  std::printf("%sin %s:", tradeoff_table(tradeoff).c_str(), options.directory.string().c_str());
  for (const auto& file : written) std::printf(" %s", file.c_str());
  std::printf("\n");
  return any_result(tradeoff) ? kDone : kFailed;
}

void add_options(CLI::App& command, TradeoffArguments& arguments) {
  command.add_option("SCENE", arguments.scene, "scene file (TOML)")->required();
  command
      .add_option("--vary", arguments.vary,
                  "PARAMETER=VALUE,VALUE,...: values of a parameter, or of any scene key by its path; repeat "
                  "for more "
                  "parameters (default: all parameters that affect the scene)")
      ->allow_extra_args(false);
  command.add_flag(
      "--variants", arguments.variants,
      "also use the scene's [[variant]] tables as settings: several parameters changed together");
  command.add_option("--seeds", arguments.seeds, "runs of each setting with consecutive seeds (default: 2)")
      ->check(whole_number(1, 1000));
  command
      .add_option(
          "--budget", arguments.budget,
          "total processor time of all runs in core minutes, including earlier calls (default: no limit)")
      ->check(number_above_zero());
  command
      .add_option("--tolerance", arguments.tolerance,
                  "accepted error in percent where the scatter over seeds is smaller (default: 2)")
      ->check(number_within(0.0, 100.0));
  command
      .add_option(
          "--target", arguments.targets,
          "NAME=VALUE: compare a quantity (its key in tradeoff.json) with a published value, in the unit of "
          "tradeoff.csv or with a unit after it; repeat for more quantities")
      ->allow_extra_args(false);
  command.add_option("--reference", arguments.reference,
                     "reference setting (default: the most expensive one that only refines)");
  command.add_option("--jobs", arguments.jobs, "runs at a time (default: 1)")->check(whole_number(1, 1024));
  command
      .add_option("--threads", arguments.threads,
                  "threads of each run (default: 1, so that waiting does not count as cost)")
      ->check(whole_number(1, 1024));
  command.add_option("--out", arguments.out,
                     "directory for results (default: out/<folder>_<scene>_tradeoff)");
  command.add_flag("--quiet", arguments.quiet, "print no progress");
}

}  // namespace

void add_tradeoff(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand(
      "tradeoff", "Run a scene with several settings and chart the cost and error of each");
  auto arguments = std::make_shared<TradeoffArguments>();
  add_options(*command, *arguments);
  command->footer(
      "Examples:\n"
      "  diefill tradeoff sample_tools/tradeoff/slit_discharge.toml --budget 30\n"
      "  diefill tradeoff my_die.toml --vary 'grain_diameter=0.94 mm,1.88 mm' --vary 'time_step=0.3,0.4' "
      "--seeds 3\n"
      "  diefill tradeoff my_die.toml --vary 'step.1.velocity=0.1 m/s,0.2 m/s' --target solid_fraction=0.34\n"
      "  diefill tradeoff sample_tools/tradeoff/narrow_ring.toml --variants --reference base\n"
      "Parameters: grain_diameter, time_step, reduced_modulus, wall_sphere_radius, wall_spacing, "
      "powder_height,\n"
      "slice_length, skin, grain_model; or the path of a key, such as powder.friction.\n"
      "Run the same command again to continue after a stop; finished runs are kept. Writes tradeoff.csv, "
      "tradeoff.json,\n"
      "tradeoff.png and parameter_<name>.png. Exit codes: 0 done, 1 no result to evaluate, 2 bad input, 130 "
      "stopped.");
  command->callback([arguments, &chosen] { chosen = [arguments] { return trade_off(*arguments); }; });
}

}  // namespace diefill::app
