#include <algorithm>
#include <cstdio>
#include <thread>

#include "app/backup_notes.h"
#include "app/commands/commands.h"
#include "app/commands/live_jobs.h"
#include "app/commands/shared_options/renderer_choice.h"
#include "app/commands/shared_options/scene_choice.h"
#include "app/exit_code.h"
#include "app/options/numbers.h"
#include "app/options/output_file.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "app/stop_signals.h"
#include "app/tables/comparison_table.h"
#include "process/compare/backups.h"
#include "process/compare/check_measured.h"
#include "process/compare/collect.h"
#include "process/compare/job_folder.h"
#include "process/compare/measured_measures.h"
#include "process/compare/run_jobs.h"
#include "process/input/scene_error.h"
#include "process/tooling/progress.h"

namespace diefill::app {

namespace {

struct CompareArguments {
  std::string scene, setting, out, export_to, collect_from;
  std::vector<std::string> measured;
  int jobs = 1, seeds = 1;
  bool quiet = false, no_pictures = false;
};

/// The exit code: 0 where every run is finished.
ExitCode exit_code_of(const results::Comparison& comparison) {
  ExitCode worst = kDone;
  for (const auto& run : comparison.runs) {
    if (run.state == "finished") continue;
    if (run.state == "not finished" || (run.exit_code != kOutOfRange && run.exit_code != kBadInput))
      return kFailed;
    if (worst != kBadInput) worst = run.exit_code == kBadInput ? kBadInput : kOutOfRange;
  }
  return worst;
}

/// Throws process::SceneError where a table or picture would take the place of a file that is read.
void refuse_overwriting(const CompareArguments& arguments, const std::string& option,
                        const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> inputs(arguments.measured.begin(), arguments.measured.end());
  inputs.emplace_back(arguments.scene);
  require_other_files(option, directory, {"comparison.json", "comparison.csv", "comparison.png"}, inputs);
}

/// Throws process::SceneError where the runs in the directory are not those of the scene.
void require_runs_of(const std::string& scene, const std::filesystem::path& directory) {
  const auto list = results::read_job_list(directory);
  const auto seeds = list.jobs.size() / std::max<std::size_t>(1, list.variants.size());
  const auto found =
      process::find_jobs(directory, {"", process::read_variants(scene), static_cast<int>(seeds), {}});
  const auto same = [](const results::Job& one, const results::Job& other) {
    return one.variant == other.variant && one.folder == other.folder;
  };
  if (found.other_scenes.empty() &&
      std::equal(list.jobs.begin(), list.jobs.end(), found.list.jobs.begin(), found.list.jobs.end(), same))
    return;
  throw process::SceneError(
      "SCENE: found \"" + scene + "\", but \"" + directory.string() +
      "\" holds runs of another scene, seed or setting; leave SCENE out, or run diefill "
      "compare without --collect");
}

int gather(const std::filesystem::path& directory, const std::vector<process::MeasuredFile>& measured) {
  std::vector<std::string> zones;
  if (!measured.empty()) zones = process::zones_of_jobs(directory);
  const auto comparison = process::collect(directory, process::measures_against(measured, zones));
  std::vector<std::filesystem::path> written = {"comparison.json", "comparison.csv"};
  write_output([&] {
    note_moved_results(process::back_up_earlier_tables(directory, comparison));
    results::write_comparison(directory, comparison);
    for (const auto& picture : draw(directory, comparison)) written.push_back(picture.filename());
  });
  std::printf("%sin %s:", comparison_table(comparison).c_str(), directory.string().c_str());
  for (const auto& file : written) std::printf(" %s", file.string().c_str());
  std::printf("\n");
  return exit_code_of(comparison);
}

std::vector<process::Variant> checked_variants(const CompareArguments& arguments) {
  auto variants = chosen_variants(arguments.scene, arguments.setting);
  process::check_seeds(variants, arguments.seeds);
  if (!process::has_variants(process::read_scene(arguments.scene)))
    print_note("note: no [[variant]]: runs the scene alone");
  return variants;
}

/// Writes the jobs into `directory`.
results::JobList jobs_in(const std::filesystem::path& directory, const CompareArguments& arguments,
                         const std::vector<process::Variant>& variants) {
  results::JobList list;
  write_output([&] {
    const std::string title = process::read_scene(arguments.scene).title;
    list = process::write_jobs(directory, {title, variants, arguments.seeds, {}}, print_note);
  });
  return list;
}

int export_jobs(const CompareArguments& arguments) {
  const std::filesystem::path directory = arguments.export_to;
  require_directory(directory, "--export-jobs");
  const auto variants = checked_variants(arguments);
  const OutputDirectory output(directory, {"tools"}, "--export-jobs");
  const auto list = jobs_in(directory, arguments, variants);
  write_output([&] { process::write_job_scripts(directory, list, print_note); });
  std::printf(
      "%zu %s in %s; copy it to where they should run and start them there:\n"
      "  sbatch slurm.sh                                 on a Slurm cluster\n"
      "  xargs -d '\\n' -n 1 -P 4 sh -c < jobs.txt        on one machine (or ./run_here.sh 4)\n"
      "then run diefill compare --collect %s\n",
      list.jobs.size(), list.jobs.size() == 1 ? "run" : "runs", directory.string().c_str(),
      directory.string().c_str());
  return kDone;
}

int collect_only(const CompareArguments& arguments, const std::vector<process::MeasuredFile>& measured) {
  refuse_overwriting(arguments, "--collect", arguments.collect_from);
  if (!arguments.scene.empty()) require_runs_of(arguments.scene, arguments.collect_from);
  return gather(arguments.collect_from, measured);
}

int compare(const CompareArguments& arguments) {
  const auto measured = process::read_measured_files(arguments.measured);
  if (!arguments.collect_from.empty()) return collect_only(arguments, measured);
  if (arguments.scene.empty())
    throw process::SceneError("SCENE: missing; give a scene file, or --collect with a directory of runs");
  if (!arguments.export_to.empty()) return export_jobs(arguments);
  const std::filesystem::path directory =
      arguments.out.empty() ? default_directory(arguments.scene) : std::filesystem::path(arguments.out);
  require_directory(directory);
  refuse_overwriting(arguments, "--out", directory);
  const auto variants = checked_variants(arguments);
  if (!measured.empty()) {
    process::Progress progress(!arguments.quiet);
    process::refuse_unmeasurable(measured, variants, progress.callback());
  }
  const OutputDirectory output(directory, {"tools", "beginnings"});
  const auto list = jobs_in(directory, arguments, variants);
  process::JobOptions options;
  options.program = std::filesystem::read_symlink("/proc/self/exe");
  options.at_once = arguments.jobs;
  options.cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.share_starts = true;
  options.pictures = !arguments.no_pictures;
  options.show_progress = !arguments.quiet;
  options.stop = &install_stop_handlers();
  options.watch = live_jobs(directory, "Comparison: " + list.title);
  process::run_jobs(directory, list, options);
  return gather(directory, measured);
}

/// Options of where results go, and of what is done instead of running.
void add_destinations(CLI::App& command, CompareArguments& arguments) {
  auto* measured =
      command
          .add_option("--measured", arguments.measured,
                      "CSV of a measured profile or map; its difference from each run is compared too")
          ->allow_extra_args(false);
  command.add_option("--out", arguments.out, "directory for results (default: out/<folder>_<scene>)");
  command.add_flag("--quiet", arguments.quiet, "print no progress");
  auto* exporting =
      command
          .add_option("--export-jobs", arguments.export_to,
                      "do not run: write scenes, command lines and job scripts to this directory")
          ->excludes(measured)
          ->excludes("--no-pictures");
  command
      .add_option("--collect", arguments.collect_from, "do not run: collect the results of such a directory")
      ->excludes(exporting)
      ->excludes("--setting")
      ->excludes("--seeds")
      ->excludes("--jobs")
      ->excludes("--no-pictures")
      ->excludes("--out");
}

}  // namespace

void add_compare(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand(
      "compare",
      "Run every [[variant]] of a scene and report differences that exceed the scatter between seeds");
  auto arguments = std::make_shared<CompareArguments>();
  command->add_option("SCENE", arguments->scene, "scene file (TOML) with [[variant]] tables");
  command->add_option("--seeds", arguments->seeds, "runs of each variant with consecutive seeds (default: 1)")
      ->check(whole_number(1, 1000));
  command->add_option("--jobs", arguments->jobs, "runs at a time, sharing the cores (default: 1)")
      ->check(whole_number(1, 1024));
  add_renderer(*command);
  command->add_flag("--no-pictures", arguments->no_pictures,
                    "draw nothing of the runs; use diefill map later");
  add_setting(*command, arguments->setting);
  add_destinations(*command, *arguments);
  command->footer(
      "Examples:\n"
      "  diefill compare sample_tools/narrow_ring/strategies.toml --jobs 2 --seeds 3\n"
      "  diefill compare strategies.toml --setting quick                  a first look with the same grains "
      "for all\n"
      "  diefill compare strategies.toml --seeds 5 --export-jobs jobs     then sbatch slurm.sh there\n"
      "  diefill compare --collect jobs\n"
      "Run the same command again to continue after a stop; finished runs are kept. Variants that differ "
      "only in\nlater steps share their common start: with one job at a time it is computed once. Writes "
      "comparison.json,\n"
      "comparison.csv and comparison.png. Exit codes: 0 all runs finished, 1 some did not, 2 bad input, 3 "
      "some left the\nvalid range of the method (the others are compared), 130 stopped.");
  command->callback([arguments, &chosen] { chosen = [arguments] { return compare(*arguments); }; });
}

}  // namespace diefill::app
