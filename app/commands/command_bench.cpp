#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands/bench/bench_trace.h"
#include "app/commands/bench/loop_figures.h"
#include "app/commands/bench/threads_and_copies.h"
#include "app/commands/bench/timed_scene.h"
#include "app/commands/commands.h"
#include "app/exit_code.h"
#include "app/freed_memory.h"
#include "app/options/choices.h"
#include "app/options/numbers.h"
#include "app/options/output_file.h"
#include "app/output.h"
#include "app/tables/json_text.h"
#include "engine/observe/memory_traffic.h"
#include "engine/observe/powder_figures.h"
#include "engine/simulation/simulation.h"
#include "process/input/scene_error.h"
#include "process/input/units.h"
#include "process/laboratory/benchmark_bed.h"
#include "process/laboratory/benchmark_law.h"
#include "process/setup/predicted_work.h"

namespace diefill::app {

namespace {

using process::laboratory::BenchmarkBed;
using process::laboratory::read_benchmark_bed;
using process::laboratory::side_by_side;

struct BenchOptions {
  std::string bed, law = "bierwisch";
  std::optional<std::string> state, trace;
  double width = 0;  ///< mm, of the box that `state` fills; 0: that of its kind
  int threads = 1, steps = 600, copies = 1, every = 100, repeats = 5;
  std::size_t spheres = 50000;
  bool json = false, against_copies = false;

  bool is_scene() const { return bed != "spheres" && bed != "clumps"; }
};

/// Steps before timing: the first searches and page faults are not typical of a run.
constexpr int kWarmUp = 100;

/// Bytes of memory that the program holds now.
double resident_bytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

engine::Simulation assembled(const process::laboratory::BenchmarkBedState& bed, int threads) {
  engine::SimulationSettings settings = bed.settings;
  settings.threads = threads;
  engine::Simulation simulation(settings, bed.walls);
  simulation.add_grains(bed.grains);
  return simulation;
}

/// Pairs of spheres of grains that touch; walls do not count.
double touching_grain_pairs(const engine::Simulation& simulation) {
  std::size_t touching = 0;
  for (const auto& block : simulation.neighbours().blocks())
    for (const auto touches : block.grain_pairs.touching) touching += touches;
  return static_cast<double>(touching);
}

/// Figures of `steps` steps from now on.
nlohmann::ordered_json timed(engine::Simulation& simulation, int steps, double bytes) {
  simulation.time_loops();
  const auto before = simulation.timers().seconds();
  const auto searches = simulation.searches();
  const std::clock_t clock = std::clock();
  for (int k = 0; k < steps; ++k) simulation.step();
  const double cpu_seconds = static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC;
  const auto after = simulation.timers().seconds();
  const auto spheres = static_cast<double>(engine::sphere_count(simulation));
  double seconds = 0;
  nlohmann::ordered_json phases;
  for (std::size_t p = 0; p < after.size(); ++p) {
    seconds += after[p] - before[p];
    phases[engine::kPhaseNames[p]] = (after[p] - before[p]) / (spheres * steps) * 1e9;
  }
  nlohmann::ordered_json figures;
  figures["sphere_steps_per_second"] = spheres * steps / seconds;
  figures["spheres"] = spheres;
  figures["steps"] = steps;
  figures["threads"] = simulation.settings().threads;
  figures["seconds"] = seconds;
  figures["cpu_nanoseconds_per_sphere_step"] = cpu_seconds / (spheres * steps) * 1e9;
  figures["nanoseconds_per_sphere_step"] = phases;
  figures["contacts_per_sphere"] = 2 * touching_grain_pairs(simulation) / spheres;
  figures["near_pairs_per_sphere"] = static_cast<double>(simulation.neighbours().near_pairs()) / spheres;
  figures["steps_per_search"] =
      static_cast<double>(steps) / std::max(1.0, static_cast<double>(simulation.searches() - searches));
  figures["bytes_per_sphere"] = bytes / spheres;
  figures["bytes_moved_per_sphere_step"] = engine::bytes_moved_per_step(simulation) / spheres;
  add_loop_figures(simulation, seconds, steps, figures);
  figures["state_hash"] = hash_text(simulation);
  return figures;
}

void print(const nlohmann::ordered_json& figures) {
  for (const auto& [name, value] : figures.items()) {
    if (!value.is_object()) {
      std::printf("%s: %s\n", name.c_str(),
                  value.is_string() ? value.get<std::string>().c_str() : value.dump().c_str());
      continue;
    }
    for (const auto& [phase, nanoseconds] : value.items())
      std::printf("%s, %s: %.2f\n", name.c_str(), phase.c_str(), nanoseconds.get<double>());
  }
}

/// Refuses a bed that does not fit into memory or that would never end. `grains` of --state; 0: a bed is
/// generated.
void refuse_excessive_work(const BenchOptions& options, BenchmarkBed kind, std::size_t grains) {
  constexpr double kSpheresOfClump = 7;
  const double copies = options.copies * static_cast<double>(options.copies);
  const double spheres = options.state ? static_cast<double>(grains) * copies *
                                             (kind == BenchmarkBed::clumps ? kSpheresOfClump : 1)
                                       : static_cast<double>(options.spheres);
  const std::string bed = "bench: " + process::number_text(spheres) + " spheres";
  process::refuse_memory(bed, spheres, 0, 0, "use fewer (--spheres, --copies)");
  const double sphere_steps = spheres * options.steps;
  if (sphere_steps > process::kMaxSphereSteps)
    throw process::SceneError(bed + " over " + std::to_string(options.steps) + " steps are " +
                              process::number_text(sphere_steps) + " sphere-steps, allowed: at most " +
                              process::number_text(process::kMaxSphereSteps) + "; use fewer (--steps)");
}

/// The grains that the options ask for.
process::laboratory::BenchmarkBedState wanted_grains(const BenchOptions& options) {
  const BenchmarkBed kind = options.bed == "spheres" ? BenchmarkBed::spheres : BenchmarkBed::clumps;
  if (!options.state) {
    refuse_excessive_work(options, kind, 0);
    return process::laboratory::loose_benchmark_bed(kind, options.spheres);
  }
  const auto bed = read_benchmark_bed(kind, *options.state, 1e-3 * options.width);
  refuse_excessive_work(options, kind, bed.grains.size());
  return side_by_side(bed, options.copies);
}

/// The bed that the options ask for.
process::laboratory::BenchmarkBedState wanted_bed(const BenchOptions& options) {
  auto bed = wanted_grains(options);
  process::laboratory::set_benchmark_law(bed, options.law);
  return bed;
}

/// The command-line arguments that select the bed or scene.
std::vector<std::string> bench_arguments(const BenchOptions& options) {
  std::vector<std::string> words = {"bench", options.bed, "--steps", std::to_string(options.steps)};
  const auto add = [&](const std::string& name, const std::string& value) {
    words.insert(words.end(), {name, value});
  };
  if (options.state) add("--state", *options.state);
  if (options.is_scene()) return words;
  add("--law", options.law);
  if (!options.state) add("--spheres", std::to_string(options.spheres));
  if (options.copies > 1) add("--copies", std::to_string(options.copies));
  if (options.width > 0) add("--width", std::to_string(options.width));
  return words;
}

/// Measures threads against copies with the same command-line arguments.
int against_copies(const BenchOptions& options) {
  CopiesBenchmark benchmark;
  benchmark.words = bench_arguments(options);
  benchmark.threads = options.threads;
  benchmark.repeats = options.repeats;
  benchmark.json = options.json;
  return compare_with_copies(benchmark);
}

/// Refuses options that apply to beds only.
void reject_bed_options(const BenchOptions& options) {
  if (options.trace || options.width > 0 || options.copies > 1 || options.law != "bierwisch")
    throw process::SceneError("bench: " + options.bed +
                              " is a scene: --law, --width, --copies and --trace are for beds; remove them");
  if (!options.state)
    throw process::SceneError("bench: " + options.bed +
                              " is a scene: --state must name the directory of a stopped run of this scene");
}

/// Throws process::SceneError where the trace cannot be written, or would overwrite the bed that it starts
/// from.
void refuse_trace(const BenchOptions& options) {
  require_directory(*options.trace, "--trace");
  if (options.state)
    require_other_files("--trace", *options.trace, {"energy.csv", "grains.csv"}, {*options.state});
}

void show(const BenchOptions& options, const nlohmann::ordered_json& figures) {
  if (options.json)
    std::printf("%s\n", json_text(figures).c_str());
  else
    print(figures);
}

int bench_scene(const BenchOptions& options) {
  TimedScene wanted;
  wanted.scene = options.bed;
  wanted.run = *options.state;
  wanted.threads = options.threads;
  wanted.warm_up = kWarmUp;
  wanted.steps = options.steps;
  show(options, timed(wanted));
  return kDone;
}

int bench(const BenchOptions& options) {
  if (options.is_scene()) reject_bed_options(options);
  if (options.trace) refuse_trace(options);
  if (options.against_copies) return against_copies(options);
  if (options.is_scene()) return bench_scene(options);
  release_freed_memory();
  const double before = resident_bytes();
  std::optional<engine::Simulation> simulation;
  simulation.emplace(assembled(wanted_bed(options), options.threads));
  if (options.trace) {
    trace(*simulation, options.steps, options.every, *options.trace);
    std::printf("in %s: energy.csv, grains.csv\n", options.trace->c_str());
    return kDone;
  }
  const int settling = options.state ? kWarmUp : process::laboratory::kBenchmarkBedFall;
  for (int k = 0; k < settling; ++k) simulation->step();
  show(options, timed(*simulation, options.steps, resident_bytes() - before));
  return kDone;
}

/// One of the beds, or a scene file that is there.
CLI::Validator bed_or_scene() {
  const std::vector<std::string> beds = {"spheres", "clumps"};
  CLI::Validator validator = one_of(beds);
  return validator.operation([beds](std::string& text) {
    const bool known = std::find(beds.begin(), beds.end(), text) != beds.end();
    if (known || std::filesystem::is_regular_file(text)) return std::string();
    return unknown_name(text, {"spheres", "clumps", "a scene file that exists"});
  });
}

/// Options of the bed: its law, where it starts and its size.
void add_bed(CLI::App& command, BenchOptions& options) {
  command
      .add_option("BED", options.bed,
                  "spheres, clumps (model D), or a scene file (TOML) with the --state of a run of it")
      ->required()
      ->check(bed_or_scene());
  command
      .add_option("--law", options.law, "contact law: bierwisch (the tuned one), or one composed of parts")
      ->check(one_of(process::laboratory::benchmark_laws()))
      ->capture_default_str();
  command
      .add_option("--state", options.state,
                  "settled bed to start from (CSV, plain or gzip; default: generate one); for a scene, the "
                  "directory of a stopped run")
      ->check(CLI::ExistingPath);
  command.add_option("--width", options.width, "side in mm of the periodic box of --state")
      ->check(number_within(1.0, 1000.0))
      ->needs("--state");
  command
      .add_option("--copies", options.copies,
                  "N: start from N x N copies of --state side by side, to measure the effect of size")
      ->check(whole_number(1, 100))
      ->needs("--state");
}

/// Options of what is measured, and how long.
void add_measurement(CLI::App& command, BenchOptions& options) {
  auto* traced =
      command.add_option("--trace", options.trace,
                         "instead of timing, write kinetic energies and the final grains to this folder");
  command.add_option("--every", options.every, "steps between energy outputs of --trace")
      ->check(whole_number(1, 100000000))
      ->needs(traced);
  command.add_option("--spheres", options.spheres, "size of a generated bed")
      ->check(whole_number(1000, 20000000));
  command.add_option("--threads", options.threads, "threads")->check(whole_number(1, 1024));
  command.add_option("--steps", options.steps, "steps to time")->check(whole_number(1, 100000000));
  auto* copies =
      command.add_flag("--against-copies", options.against_copies,
                       "time N threads alternately with N pinned programs of one thread each (N: --threads)");
  command.add_option("--repeats", options.repeats, "measurements of --against-copies; the median is printed")
      ->check(whole_number(1, 1000))
      ->needs(copies);
  command.add_flag("--json", options.json, "print JSON");
}

}  // namespace

void add_bench(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand("bench", "Time the engine on a settled bed, or in a running scene");
  auto options = std::make_shared<BenchOptions>();
  add_bed(*command, *options);
  add_measurement(*command, *options);
  command->footer(
      "Examples:\n  diefill bench clumps\n  diefill bench spheres --law hertz-mindlin --threads 2 --json\n"
      "  diefill bench my_die.toml --state out/my_die --threads 8 --against-copies\n"
      "Timings are noisy: compare only figures measured alternately in one session.");
  command->callback([options, &chosen] { chosen = [options] { return bench(*options); }; });
}

}  // namespace diefill::app
