#include "process/plan/plan.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/numerics/seconds_since.h"
#include "process/plan/apply_setting.h"
#include "process/plan/pilot_cache.h"
#include "process/powder/material.h"
#include "process/scene/powder/unchanged_preset.h"
#include "process/setup/build_tooling.h"
#include "process/setup/cover_tooling.h"
#include "process/setup/predicted_work.h"
#include "process/tooling/predicted_memory.h"

namespace diefill::process::plan {

namespace {

/// The scene with `numbers`, on the prepared steps of `scene`.
Scene changed(const Scene& scene, const SettingNumbers& numbers, const std::string& origin) {
  Scene other = with_numbers(scene, numbers, origin);
  other.steps = scene.steps;
  return other;
}

/// Wall spheres of `spacing` where `tooling` has those of `scene`: as many to an area as the spacing allows.
std::size_t wall_spheres_at(double spacing, const Scene& scene, const Tooling& tooling) {
  double count = 0;
  for (const Tool& tool : tooling.tools) {
    const double ratio = tool.spec.spacing ? 1 : scene.walls.spacing / spacing;
    count += ratio * ratio * static_cast<double>(tool.spheres.centres.size());
  }
  return static_cast<std::size_t>(std::llround(count));
}

Choice choice_of(const std::string& name, const Scene& scene, const Tooling& tooling,
                 const std::optional<Pilot>& pilot, double opening) {
  Choice choice;
  choice.name = name;
  choice.forecast = pilot ? forecast(scene, tooling, *pilot) : forecast(scene, tooling);
  choice.errors = expected_errors(powder_as_published(scene), scene.powder.grain_diameter,
                                  lengths_of(scene, tooling, opening));
  return choice;
}

Choice choice_with(const std::string& name, const SettingNumbers& numbers, const Scene& scene,
                   const Tooling& tooling, const std::optional<Pilot>& pilot, double opening) {
  Choice choice = choice_of(name, changed(scene, numbers, name), tooling, pilot, opening);
  choice.numbers = numbers;
  const auto before = static_cast<double>(choice.forecast.wall_spheres);
  choice.forecast.wall_spheres = wall_spheres_at(numbers.wall_spacing, scene, tooling);
  choice.forecast.memory +=
      predicted_memory(0, static_cast<double>(choice.forecast.wall_spheres)) - predicted_memory(0, before);
  return choice;
}

}  // namespace

Plan make_plan(const Scene& scene, const PlanOptions& options) {
  Plan plan;
  const auto began = std::chrono::steady_clock::now();
  SceneWithSetting chosen = apply_setting(scene, std::nullopt);
  plan.scene = std::move(chosen.scene);
  const double sphere = smallest_sphere(engine_settings(plan.scene, 1.0));
  const double grain = largest_grain(plan.scene);
  if (chosen.tooling) refuse_excessive_work(plan.scene);
  plan.tooling = chosen.tooling ? cover_tooling(plan.scene, std::move(*chosen.tooling), sphere, grain,
                                                options.on_progress)
                                : build_tooling(plan.scene, sphere, grain, options.on_progress);
  plan.scene = with_prepared_steps(std::move(plan.scene), plan.tooling);
  plan.tooling_seconds = engine::seconds_since(began);
  plan.needs = needs_of(plan.scene, plan.tooling);
  plan.statements = description(plan.needs, plan.scene, plan.tooling);
  if (const std::string why = why_no_settings(plan.scene); !why.empty())
    plan.statements.push_back("settings quick, working and reference do not apply: " + why);
  if (options.tools_ready) options.tools_ready(plan.scene, plan.tooling);
  if (options.narrowest_opening) plan.opening = options.narrowest_opening(plan.scene, plan.tooling);
  if (options.pilot) plan.pilot = pilot_for(plan.scene, plan.tooling, options);
  add_choices(plan);
  return plan;
}

void add_choices(Plan& plan) {
  plan.choices.push_back(
      choice_of("as the scene has it", plan.scene, plan.tooling, plan.pilot, plan.opening));
  if (!why_no_settings(plan.scene).empty()) return;
  for (const Setting setting : {Setting::quick, Setting::working, Setting::reference})
    plan.choices.push_back(choice_with(description(setting),
                                       numbers_of(setting, plan.scene, plan.tooling.all_cavities()),
                                       plan.scene, plan.tooling, plan.pilot, plan.opening));
}

std::optional<Choice> finest_within(const Plan& plan, double minutes) {
  if (!plan.pilot || !why_no_settings(plan.scene).empty()) return std::nullopt;
  SettingNumbers numbers = numbers_of(Setting::working, plan.scene, plan.tooling.all_cavities());
  const auto with = [&](double diameter) {
    numbers.grain_diameter = diameter;
    return choice_with("fits the time", numbers, plan.scene, plan.tooling, plan.pilot, plan.opening);
  };
  const auto fits = [&](const Choice& choice) {
    return choice.forecast.wall_seconds && *choice.forecast.wall_seconds <= 60 * minutes;
  };
  const Setting ends[] = {Setting::reference, Setting::quick};
  double finest = numbers_of(ends[0], plan.scene, plan.tooling.all_cavities()).grain_diameter;
  double coarsest = numbers_of(ends[1], plan.scene, plan.tooling.all_cavities()).grain_diameter;
  if (fits(with(finest))) return with(finest);
  if (!fits(with(coarsest))) return std::nullopt;
  constexpr double kClose = 1.005;
  while (coarsest > kClose * finest) {
    const double middle = std::sqrt(finest * coarsest);
    (fits(with(middle)) ? coarsest : finest) = middle;
  }
  return with(coarsest);
}

std::optional<std::size_t> cheapest_within(const Plan& plan, double error) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < plan.choices.size(); ++k) {
    const Choice& choice = plan.choices[k];
    const ExpectedError* worst = largest(choice.errors);
    if (worst == nullptr || worst->error > error) continue;
    if (!best || choice.forecast.sphere_steps() < plan.choices[*best].forecast.sphere_steps()) best = k;
  }
  return best;
}

}  // namespace diefill::process::plan
