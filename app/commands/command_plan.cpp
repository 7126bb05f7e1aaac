#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "app/commands/commands.h"
#include "app/commands/shared_options/scene_choice.h"
#include "app/exit_code.h"
#include "app/freed_memory.h"
#include "app/options/numbers.h"
#include "app/tables/comparison_plan_report.h"
#include "app/tables/estimate_report.h"
#include "app/tables/json_text.h"
#include "app/tables/plan_report.h"
#include "app/tables/rank_report.h"
#include "app/tables/variant_estimates.h"
#include "process/estimate/openings/openings.h"
#include "process/plan/pilot_cache.h"
#include "process/tooling/progress.h"

namespace diefill::app {

namespace {

constexpr const char* kPilotStarts = "pilot run: about ten seconds, more where the scene itself takes hours";

struct PlanArguments {
  std::string scene, setting;
  std::vector<std::string> changes;
  std::optional<double> minutes, error;
  int threads = 0, ranks = 0;
  bool json = false, no_benchmark = false, variants = false, new_pilot = false;
};

void print_within_time(const process::plan::Plan& plan, double minutes,
                       const std::optional<process::plan::Choice>& choice) {
  if (!plan.pilot) {
    std::printf("within %.4g minutes: unknown without the pilot run\n", minutes);
  } else if (plan.choices.size() == 1) {
    std::printf("within %.4g minutes: no settings to choose from; as it is the scene takes %s\n", minutes,
                process::duration_text(plan.choices[0].forecast.wall_seconds.value_or(0)).c_str());
  } else if (!choice) {
    std::printf("within %.4g minutes: nothing fits; the quick setting takes %s\n", minutes,
                process::duration_text(plan.choices[1].forecast.wall_seconds.value_or(0)).c_str());
  } else {
    std::printf("within %.4g minutes: %s (%zu spheres, %s)\n", minutes,
                scene_lines(plan.scene, *choice->numbers).c_str(), choice->forecast.spheres,
                process::duration_text(*choice->forecast.wall_seconds).c_str());
  }
}

void print_within_error(const process::plan::Plan& plan, double error,
                        const std::optional<std::size_t>& best) {
  if (!best) {
    std::printf("error up to %.4g: unknown; no choice has a measured error this small\n", error);
    return;
  }
  const auto& choice = plan.choices[*best];
  std::printf("error up to %.4g: %s (%s)\n", error, choice.name.c_str(),
              process::plan::text_of_errors(choice.errors).c_str());
}

void print_json(const nlohmann::ordered_json& json) {
  std::printf("%s\n", json_text(json).c_str());
}

/// Prints the title and the estimate before the pilot runs.
void print_estimate_first(const process::Scene& scene, const process::estimate::Estimate& estimate) {
  std::printf("%s\n", scene.title.c_str());
  print_estimate_in_short(estimate);
  std::fflush(stdout);
}

/// Predictions for a scene's variants: their cost, and the estimate of each by formula.
struct VariantsPlan {
  process::plan::ComparisonForecast cost;
  std::vector<VariantEstimate> estimates;
};

VariantsPlan plan_of_variants(const PlanArguments& arguments, process::plan::PlanOptions options) {
  process::Progress progress(true);
  VariantsPlan planned;
  options.on_progress = progress.callback();
  options.pilot_starts = [&progress] { progress.note(kPilotStarts); };
  options.tools_ready = [&planned](const process::Scene& scene, const process::Tooling& tooling) {
    planned.estimates.push_back({"", process::estimate::estimate(scene, tooling)});
  };
  release_freed_memory();
  const auto variants = chosen_variants(arguments.scene, arguments.setting);
  planned.cost = process::plan::forecast_comparison(variants, options);
  for (std::size_t k = 0; k < variants.size(); ++k) planned.estimates[k].name = variants[k].name;
  return planned;
}

int plan_variants(const PlanArguments& arguments, const process::plan::PlanOptions& options) {
  const std::string title = process::read_scene(arguments.scene).title;
  const VariantsPlan planned = plan_of_variants(arguments, options);
  if (arguments.json) {
    auto json = comparison_plan_as_json(title, planned.cost);
    for (std::size_t k = 0; k < planned.estimates.size(); ++k)
      json["variants"][k]["estimate"] = estimate_in_short_as_json(planned.estimates[k].estimate);
    print_json(json);
    return kDone;
  }
  print_comparison_plan(title, planned.cost, options.threads);
  std::printf("\nestimate without simulation:\n");
  print_variant_estimates(planned.estimates);
  return kDone;
}

process::plan::PlanOptions plan_options(const PlanArguments& arguments) {
  process::plan::PlanOptions options;
  options.threads = arguments.threads > 0
                        ? arguments.threads
                        : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  options.pilot = !arguments.no_benchmark;
  options.pilots = process::plan::pilot_cache_folder();
  options.new_pilot = arguments.new_pilot;
  return options;
}

/// The plan of one scene and, once the tools are read, its estimate.
process::plan::Plan plan_scene(const PlanArguments& arguments, process::plan::PlanOptions options,
                               std::optional<process::estimate::Estimate>& estimate) {
  std::optional<process::Progress> progress(std::in_place, true);
  options.on_progress = progress->callback();
  options.tools_ready = [&](const process::Scene& scene, const process::Tooling& tooling) {
    estimate = process::estimate::estimate(scene, tooling);
    options.on_progress = process::ignore_progress;
    progress.reset();  // removes its bar before other output
    if (!arguments.json) print_estimate_first(scene, *estimate);
  };
  options.pilot_starts = [] { process::Progress(true).note(kPilotStarts); };
  options.narrowest_opening = process::estimate::narrowest_hole;
  release_freed_memory();  // as in the runs whose memory is predicted
  return process::plan::make_plan(changed_scene(arguments.scene, arguments.changes), options);
}

int plan(const PlanArguments& arguments) {
  const process::plan::PlanOptions options = plan_options(arguments);
  if (arguments.variants) return plan_variants(arguments, options);
  std::optional<process::estimate::Estimate> estimate;
  const process::plan::Plan plan = plan_scene(arguments, options, estimate);
  std::optional<process::plan::Choice> in_time;
  std::optional<std::size_t> in_error;
  if (arguments.minutes) in_time = process::plan::finest_within(plan, *arguments.minutes);
  if (arguments.error) in_error = process::plan::cheapest_within(plan, *arguments.error);
  if (!arguments.json) {
    print_plan(plan);
    if (arguments.minutes) print_within_time(plan, *arguments.minutes, in_time);
    if (arguments.error) print_within_error(plan, *arguments.error, in_error);
    if (arguments.ranks > 0) print_rank_forecast(plan, options.threads, arguments.ranks);
    if (process::has_variants(plan.scene))
      std::printf("this is the scene without its [[variant]]s; use diefill plan --variants to plan them\n");
    return kDone;
  }
  auto json = plan_as_json(plan);
  json["estimate"] = estimate ? estimate_as_json(*estimate) : nullptr;
  if (arguments.minutes) json["within_minutes"] = in_time ? choice_as_json(*in_time) : nullptr;
  if (arguments.error) {
    json["within_error"] = nullptr;
    if (in_error) json["within_error"] = plan.choices[*in_error].name;
  }
  print_json(json);
  return kDone;
}

constexpr const char* kPlanFooter =
    "Reads the tools, begins with what diefill estimate says, runs the scene with less and coarser powder "
    "for about\nten seconds (once per machine: the pilot is kept in ~/.cache/diefill/pilots), and prints "
    "what the scene needs and\nwhat it would cost as written and with the settings quick, working and "
    "reference (diefill run --setting).\n"
    "Examples:\n  diefill plan sample_tools/narrow_ring/fill.toml\n"
    "  diefill plan my_die.toml --minutes 60\n"
    "  diefill plan my_die.toml --json --no-benchmark\n"
    "  diefill plan sample_tools/stepped_ring/strategies.toml --variants --setting quick";

}  // namespace

void add_plan(CLI::App& program, Action& chosen) {
  auto* command =
      program.add_subcommand("plan", "Print what a scene needs and predict its size, memory and time");
  auto arguments = std::make_shared<PlanArguments>();
  command->add_option("SCENE", arguments->scene, "scene file (TOML)")->required();
  auto* minutes = command
                      ->add_option("--minutes", arguments->minutes,
                                   "pick the finest grains that fit this wall-clock time")
                      ->check(number_within(0.01, 1e6));
  auto* error =
      command
          ->add_option("--error", arguments->error,
                       "pick the cheapest setting whose measured error is at most this share, such as 0.05")
          ->check(number_within(1e-6, 1.0));
  command->add_option("--threads", arguments->threads, "threads of the planned run (default: all cores)")
      ->check(whole_number(1, 1024));
  command
      ->add_option(
          "--ranks", arguments->ranks,
          "also predict the time of diefill run with this many --ranks, and from which size on it pays")
      ->check(whole_number(1, 1000000));
  command->add_flag("--no-benchmark", arguments->no_benchmark,
                    "skip the pilot run; wall times are then unknown");
  command->add_flag("--new-pilot", arguments->new_pilot,
                    "run the pilot again even if one of this scene, machine and program is kept");
  auto* variants =
      command
          ->add_flag("--variants", arguments->variants,
                     "predict diefill compare: each [[variant]] of the scene, with its estimate, "
                     "and all together")
          ->excludes(minutes)
          ->excludes(error);
  auto* setting = add_setting(*command, arguments->setting)->needs(variants);
  setting->description("with --variants: " + setting->get_description());
  add_changes(*command, arguments->changes);
  variants->excludes("--set");
  command->add_flag("--json", arguments->json, "print JSON, SI units");
  command->footer(kPlanFooter);
  command->callback([arguments, &chosen] { chosen = [arguments] { return plan(*arguments); }; });
}

}  // namespace diefill::app
