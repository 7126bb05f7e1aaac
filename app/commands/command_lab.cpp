#include <cmath>
#include <cstdio>

#include "app/commands/commands.h"
#include "app/commands/lab_experiments.h"
#include "app/exit_code.h"
#include "app/options/choices.h"
#include "app/options/numbers.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "process/input/scene_error.h"
#include "process/laboratory/flow/registry.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/walls/registry.h"
#include "render/charts/experiment_chart.h"

namespace diefill::app {

namespace {

using process::laboratory::Experiment;

struct LabArguments {
  std::string name = "all", out, scenes;
  process::laboratory::ExperimentOptions options;
};

/// A family of experiments, as it is called on the command line.
struct Family {
  const char *name, *help;
  const std::vector<Experiment>& (*experiments)();
};

const Family kFamilies[] = {
    {"stability", "Find the limits of each method and compare them with theory",
     process::laboratory::stability_experiments},
    {"walls", "Compare wall spheres with the exact surface", process::laboratory::wall_experiments},
    {"flow", "Compare flow out of a hopper with the kinematic models", process::laboratory::flow_experiments},
};

/// The experiments that `name` asks for; throws SceneError where there is none.
std::vector<Experiment> wanted(const Family& family, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& experiment : family.experiments()) {
    if (name == "all") return family.experiments();
    if (name == experiment.name) return {experiment};
    names.push_back(experiment.name);
  }
  names.emplace_back("all");
  throw process::SceneError(std::string("lab ") + family.name +
                            ": unknown experiment: " + unknown_name(name, names));
}

void print(const results::ExperimentResult& result) {
  std::printf("%s: %s (%.1f s of processor time)\n", result.name.c_str(), result.question.c_str(),
              result.cpu_seconds);
  for (const auto& limit : result.limits) {
    std::printf("  %s: ", limit.name.c_str());
    if (std::isnan(limit.measured))
      std::printf("no value");
    else
      std::printf("%.4g %s", limit.measured, limit.unit.c_str());
    if (limit.predicted == limit.predicted)
      std::printf(", predicted %.4g (%s)", limit.predicted, limit.source.c_str());
    std::printf("\n");
  }
  std::fflush(stdout);
}

results::ExperimentResult perform_telling(const Experiment& one,
                                          process::laboratory::ExperimentOptions options) {
  process::Progress progress(true);
  options.on_progress = progress.callback();
  return process::laboratory::perform(one, options);
}

/// Ids of the published figures that the results are compared with.
std::vector<std::string> published_figures_of(const std::vector<Experiment>& experiments) {
  std::vector<std::string> ids;
  for (const auto& one : experiments)
    ids.insert(ids.end(), one.published_figures.begin(), one.published_figures.end());
  return ids;
}

int experiment(const Family& family, const LabArguments& arguments) {
  const auto experiments = wanted(family, arguments.name);
  // Before the experiments, which may take hours.
  const auto ids = published_figures_of(experiments);
  const auto published = ids.empty() ? PublishedFigures() : published_figures_in(arguments.scenes, ids);
  const std::filesystem::path out = arguments.out.empty() ? std::string("out/") + family.name : arguments.out;
  make_output_directory(out);
  set_up_drawing();
  std::vector<results::ExperimentResult> found;
  for (const auto& one : experiments) {
    found.push_back(perform_telling(one, arguments.options));
    print(found.back());
    write_output([&] {
      results::write_experiment(out, found.back());
      for (const auto& chart : found.back().charts) render::draw_experiment(out, chart);
      write_figures(out, found.back(), published);
      results::write_limits(out, family.name, found);
    });
  }
  std::printf("tables and charts in %s: %s.csv, %s.json, one PNG and CSV per chart\n", out.string().c_str(),
              family.name, family.name);
  return kDone;
}

void add_family(CLI::App& lab, const Family& family, Action& chosen) {
  auto* command = lab.add_subcommand(family.name, family.help);
  auto arguments = std::make_shared<LabArguments>();
  command->add_option("NAME", arguments->name, "experiment (default: all)");
  command->add_flag("--quick", arguments->options.quick, "small beds and few points");
  command->add_option("--out", arguments->out,
                      std::string("directory for tables and charts (default: out/") + family.name + ")");
  command->add_option("--threads", arguments->options.threads, "number of threads; does not affect results")
      ->check(whole_number(1, 1024));
  if (!published_figures_of(family.experiments()).empty())
    command->add_option("--scenes", arguments->scenes,
                        "folder of the published figures (default: sample_tools/laboratory that comes with "
                        "the program)");
  std::string names = "Experiments:\n";
  for (const auto& known : family.experiments()) names += "  " + known.name + ": " + known.question + "\n";
  command->footer(names);
  command->callback([arguments, &family, &chosen] {
    chosen = [arguments, &family] { return experiment(family, *arguments); };
  });
}

/// Experiments with scenes, then families with theirs.
std::string list_of_all() {
  std::string text = list_of_experiments("");
  for (const auto& family : kFamilies) {
    text += std::string(family.name) + ": " + family.help + '\n';
    for (const auto& one : family.experiments()) text += "  " + one.name + ": " + one.question + '\n';
  }
  return text;
}

}  // namespace

void add_lab(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand(
      "lab", "Experiments of the sources against published figures, and limits of the method");
  command->require_subcommand(0, 1);
  auto list = std::make_shared<bool>(false);
  command->add_flag("--list", *list, "list all experiments");
  for (const auto& family : kFamilies) add_family(*command, family, chosen);
  add_lab_experiments(*command, chosen);
  command->callback([command, list, &chosen] {
    if (*list)
      chosen = [] {
        std::printf("%s", list_of_all().c_str());
        return kDone;
      };
    else if (command->get_subcommands().empty())
      throw CLI::ValidationError("lab: no experiment given; diefill lab --list names them");
  });
  command->footer(
      "Examples:\n  diefill lab --list\n  diefill lab mean_fractions --seeds 3 --budget 10\n  diefill lab "
      "stability --quick\n"
      "  diefill lab stability time_step --out out/limits");
}

}  // namespace diefill::app
