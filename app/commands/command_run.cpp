#include <cstdio>
#include <optional>
#include <thread>

#include "app/commands/commands.h"
#include "app/commands/earlier_run.h"
#include "app/commands/live_run.h"
#include "app/commands/powder_sample_runs.h"
#include "app/commands/ranks/run_on_ranks.h"
#include "app/commands/ranks/step_engine.h"
#include "app/commands/shared_options/renderer_choice.h"
#include "app/commands/shared_options/scene_choice.h"
#include "app/exit_code.h"
#include "app/freed_memory.h"
#include "app/options/numbers.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "app/pictures/paraview_series.h"
#include "app/stop_signals.h"
#include "app/tables/check_report.h"
#include "app/tables/run_summary.h"
#include "process/cluster/rank_limits.h"
#include "process/estimate/openings/openings.h"
#include "process/input/scene_error.h"
#include "process/plan/expected_error.h"
#include "process/powder/material.h"
#include "process/results/figure_table.h"
#include "process/results/probe_table.h"
#include "process/results/storage/result_file.h"
#include "process/run/assemble.h"
#include "process/run/outcome.h"
#include "process/run/restart/input_record.h"
#include "process/scene/powder/unchanged_preset.h"
#include "process/scene/snapshot_folder.h"

namespace diefill::app {

namespace {

struct RunArguments {
  std::string scene, directory, setting, shared_starts;
  std::vector<std::string> changes;
  int threads = 0;
  bool resume = false, quiet = false, no_pictures = false;
  PowderSampleArguments samples;
  RankArguments ranks;
};

/// out/<folder of the scene>, or out/<name of the scene> where its file name says more than "fill".
std::filesystem::path directory_of_run(const std::filesystem::path& scene) {
  if (scene.stem() != "fill") return default_directory(scene);
  return std::filesystem::path("out") / std::filesystem::absolute(scene).parent_path().filename();
}

void print_summary(const results::FillResult& result) {
  const auto& figures = result.figures;
  std::printf("%s: %s\n", result.title.c_str(), result.strategy.c_str());
  std::printf("%s", filling_text(result).c_str());
  std::printf(
      "%.0f grains of d = %s, %.0f steps of %.3g s, %.3g s of simulated time in %s, %.2f million "
      "sphere-steps/s\n",
      figures.at("grains"), result.powder.sizes_text().c_str(), figures.at("steps"),
      figures.at("time_step_s"), figures.at("simulated_s"),
      process::duration_text(figures.at("wall_seconds")).c_str(),
      1e-6 * figures.at("sphere_steps_per_second"));
  std::printf("state %s, %s %.2g\n", result.state_hash.c_str(),
              results::short_label(results::figure_called("energy_balance_error")).c_str(),
              figures.at("energy_balance_error"));
  for (const auto& warning : result.warnings)
    if (!warning.starts_with(process::kAlert)) std::printf("note: %s\n", warning.c_str());
}

process::RunOptions options_of(const RunArguments& arguments, const process::Scene& scene) {
  process::RunOptions options;
  options.directory =
      arguments.directory.empty() ? directory_of_run(scene.file) : std::filesystem::path(arguments.directory);
  // The other cores of this machine are those of other ranks.
  const unsigned all = step_engine() != nullptr ? 1U : std::thread::hardware_concurrency();
  options.threads = arguments.threads > 0 ? arguments.threads : static_cast<int>(std::max(1U, all));
  options.resume = arguments.resume;
  options.shared_starts = arguments.shared_starts;
  options.show_progress = !arguments.quiet;
  options.engine = step_engine();
  return options;
}

/// Adds what is known of the error that the grain size makes, so that every report says it.
void note_expected_errors(const process::Scene& scene, const process::Tooling& tooling,
                          results::FillResult& result) {
  const double opening =
      tooling.all_cavities().narrowest_width > 0 ? 0 : process::estimate::narrowest_hole(scene, tooling);
  const auto errors =
      process::plan::expected_errors(process::powder_as_published(scene), scene.powder.grain_diameter,
                                     process::plan::lengths_of(scene, tooling, opening));
  if (!errors.empty())
    result.warnings.push_back(
        "errors to be expected of this grain size: " + process::plan::text_of_errors(errors) +
        "; measured in " + errors.front().source);
}

/// Says why the run ended before the scene.
int unfinished(const process::FillRun& fill) {
  std::fprintf(stderr, "diefill: %s: results cover the simulated time only; %s\n",
               fill.why_unfinished().c_str(),
               fill.cannot_end() ? "wait for less, or give the step another end, and run again"
                                 : "raise max_time and run the same command with --resume to continue");
  return kUnfinished;
}

int run_samples(const RunArguments& arguments, const process::Scene& scene,
                const std::filesystem::path& results) {
  PowderSampleArguments samples = arguments.samples;
  samples.quiet = arguments.quiet;
  samples.threads = arguments.threads;
  return run_powder_samples(
      scene, arguments.directory.empty() ? results.string() + "_powder_samples" : arguments.directory,
      samples);
}

auto snapshot_writer(const process::Scene& scene, const process::Tooling& tooling,
                     const std::filesystem::path& directory) {
  return [&, directory](const process::FillRun& under_way, const std::string& name) {
    const auto folder = directory / "snapshots" / process::snapshot_folder(name);
    write_output([&] {
      const auto snapshot = process::assemble(scene, tooling, under_way);
      results::write_results(folder, snapshot);
      results::write_report(folder, snapshot);
    });
  };
}

/// Runs to the end; the page that tells of it says how it ended.
void run_watched(process::FillRun& fill, LiveRun& live) {
  try {
    fill.run();
  } catch (const std::exception& error) {
    live.end(fill, std::string("stopped: ") + error.what(), false);
    throw;
  }
  const std::string unfinished = fill.why_unfinished();
  live.end(fill, unfinished.empty() ? "done" : "unfinished: " + unfinished, unfinished.empty());
}

/// Writes all results and says where they are. Returns the exit code.
int deliver(const RunArguments& arguments, const process::Scene& scene, const process::Tooling& tooling,
            const std::vector<process::InputFile>& files, const std::filesystem::path& directory,
            const process::FillRun& fill) {
  auto result = process::assemble(scene, tooling, fill);
  process::add_input_files(files, result);
  note_expected_errors(scene, tooling, result);
  std::vector<std::filesystem::path> pictures, series;
  write_output([&] {
    results::write_results(directory, result);
    results::write_report(directory, result);
    results::write_probe_tables(directory, result);
    if (!arguments.no_pictures) pictures = draw(directory, result);
    series = write_filling_series(result, directory / "paraview", directory / "filling.pvd");
  });
  const bool finished = fill.why_unfinished().empty();
  if (finished) remove_checkpoint(directory);
  print_summary(result);
  std::printf("results in %s: report.json, results.h5 (results.xdmf for ParaView)",
              directory.string().c_str());
  for (const auto& picture : pictures) std::printf(", %s", picture.filename().string().c_str());
  if (!series.empty()) std::printf(", %s (plays in ParaView)", series.back().filename().string().c_str());
  std::printf("\n");
  print_alerts(process::alerts_of(result.warnings));
  return finished ? kDone : unfinished(fill);
}

int run(const RunArguments& arguments) {
  process::Scene scene = chosen_scene(arguments.scene, arguments.setting, arguments.changes);
  const auto files = process::input_files(scene.text, scene.file);  // as they were read, not at the end
  if (arguments.ranks.ranks > 0) return run_on_ranks(arguments.ranks, scene);
  if (step_engine() != nullptr) {
    process::cluster::refuse_unsupported_on_ranks(scene);
    if (arguments.samples.powders > 0)
      throw process::SceneError("--powder-samples runs many scenes and is not supported on ranks");
  }
  process::RunOptions options = options_of(arguments, scene);
  options.inputs = files;
  require_directory(options.directory);
  require_writable(options.directory);  // set-up may take minutes
  if (!arguments.shared_starts.empty()) require_directory(arguments.shared_starts, "--beginnings");
  if (arguments.samples.powders > 0) return run_samples(arguments, scene, options.directory);
  refuse_inputs_to_be_moved(scene, options.directory);
  std::optional<OutputDirectory> output;
  // Before work that would be lost if a second run were refused.
  if (std::filesystem::exists(options.directory)) output.emplace(options.directory);
  if (arguments.resume) refuse_changed_inputs(scene, files, options.directory);
  const auto tooling = prepared_tooling(scene, !arguments.quiet);
  scene = process::with_prepared_steps(std::move(scene), tooling);
  if (arguments.resume && is_finished(options.directory, scene, tooling)) return kDone;
  options.snapshot = snapshot_writer(scene, tooling, options.directory);
  LiveRun live(scene, tooling, options.directory, !arguments.no_pictures);
  options.watch = [&live](const process::FillRun& under_way) { live.update(under_way); };
  release_freed_memory();
  options.stop = &install_stop_handlers();
  process::FillRun fill(scene, tooling, options);  // refuses what cannot be begun, in one line
  if (options.stop->load()) throw process::Interrupted(kStoppedDuringSetUp);
  print_alerts(finding_lines(process::setup_findings(scene, tooling)));
  if (!output) output.emplace(options.directory);
  if (!options.shared_starts.empty()) make_output_directory(options.shared_starts, "--beginnings");
  clear_for_run(options.directory, arguments.resume, files);
  run_watched(fill, live);
  return deliver(arguments, scene, tooling, files, options.directory, fill);
}

void add_powder_samples(CLI::App& command, PowderSampleArguments& samples) {
  auto* powders =
      command
          .add_option(
              "--powder-samples", samples.powders,
              "run the scene with so many powders that agree with the data of its powder.file, beside "
              "the best one with several seeds")
          ->check(whole_number(2, 1000));
  command.add_option("--seeds", samples.seeds, "with --powder-samples: runs of the best powder (default: 4)")
      ->check(whole_number(2, 1000))
      ->needs(powders);
  command.add_option("--jobs", samples.jobs, "with --powder-samples: runs at a time (default: 1)")
      ->check(whole_number(1, 1024))
      ->needs(powders);
}

}  // namespace

void add_run(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand("run", "Simulate a scene; write density maps, results and report");
  auto arguments = std::make_shared<RunArguments>();
  command->add_option("SCENE", arguments->scene, "scene file (TOML)")->required();
  command->add_option("--out", arguments->directory,
                      "directory for results (default: out/<folder of the scene>)");
  command
      ->add_option("--threads", arguments->threads,
                   "number of threads (default: all cores); does not affect results")
      ->check(whole_number(1, 1024));
  add_renderer(*command);
  add_setting(*command, arguments->setting);
  add_changes(*command, arguments->changes);
  command->add_flag("--resume", arguments->resume,
                    "continue from the checkpoint in the results directory; a finished run is kept");
  command->add_option("--beginnings", arguments->shared_starts,
                      "directory where runs with the same start share it");
  command->add_flag("--no-pictures", arguments->no_pictures, "draw nothing; use diefill map later");
  command->add_flag("--quiet", arguments->quiet, "print no progress");
  add_powder_samples(*command, arguments->samples);
  add_ranks(*command, arguments->ranks);
  command->get_option("--ranks")->excludes("--powder-samples");
  command->footer(
      "Examples:\n"
      "  diefill run sample_tools/narrow_ring/fill.toml\n"
      "  diefill run my_die.toml --out results/my_die --threads 8\n"
      "  diefill run my_die.toml --setting quick                   a first look (diefill plan describes it)\n"
      "  diefill run my_die.toml --out results/my_die --resume     after Ctrl-C or a crash\n"
      "  diefill run my_die.toml --ranks 64 --hostfile hosts      on many machines "
      "(process/cluster/README.md)\n"
      "  diefill run my_die.toml --powder-samples 12 --jobs 2      what the powder's uncertainty does to the "
      "filling\n"
      "Earlier results and pictures in the directory are moved to its folder previous-1, previous-2, ...\n"
      "Exit codes: 0 done, 1 failed, 2 bad input, 3 valid range of the method exceeded, 4 unfinished:\n"
      "numerics.max_time ended before the scene (resume with a larger one), or it waits for a mass or a "
      "force\n"
      "that powder at rest never brings, 130 stopped (can be resumed). Results of 4 cover the simulated "
      "time.");
  command->callback([arguments, &chosen] { chosen = [arguments] { return run(*arguments); }; });
}

}  // namespace diefill::app
