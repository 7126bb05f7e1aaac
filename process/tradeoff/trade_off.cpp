#include "process/tradeoff/trade_off.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "process/input/nearest_key.h"
#include "process/results/studies/job_cost.h"
#include "process/tooling/progress.h"
#include "process/tradeoff/evaluate.h"
#include "process/tradeoff/gather.h"
#include "process/tradeoff/quantities.h"

namespace diefill::process {
namespace {

constexpr double kWorthwhile = 0.97;  // of the base's cost: a parameter that saves less is left where it is

void refuse_unknown(const std::string& what, const std::string& word, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), word) != known.end()) return;
  std::string message = what + ": found \"" + word + "\", which does not exist; ";
  if (const auto meant = nearest_key(word, known))
    throw SceneError(message + "did you mean \"" + *meant + "\"?");
  message += "allowed:";
  for (std::size_t k = 0; k < known.size(); ++k) message += (k == 0 ? " \"" : ", \"") + known[k] + '"';
  throw SceneError(message);
}

void check_words(const Scene& scene, const std::vector<TriedSetting>& settings,
                 const TradeoffOptions& options) {
  std::vector<std::string> quantities, names = {kCombined};
  for (const auto& quantity : measured_quantities(scene)) quantities.push_back(quantity.about.key);
  for (const auto& [key, value] : options.targets) refuse_unknown("--target", key, quantities);
  for (const TriedSetting& setting : settings) names.push_back(setting.name);
  if (!options.reference.empty()) refuse_unknown("--reference", options.reference, names);
}

const TriedSetting& setting_called(const std::vector<TriedSetting>& settings, const std::string& name) {
  return *std::find_if(settings.begin(), settings.end(),
                       [&](const TriedSetting& setting) { return setting.name == name; });
}

/// What a job will cost (s of processor time) from what others have: from another seed of its setting, or
/// else from the setting whose work is nearest. Nothing while none is known.
std::optional<double> predicted_cost(const std::filesystem::path& directory,
                                     const std::vector<TriedSetting>& settings, int seeds,
                                     const TriedSetting& setting) {
  std::optional<double> predicted;
  double nearest = 0;
  for (const TriedSetting& other : settings)
    for (const results::Job& job : jobs_of(other, seeds)) {
      if (state_of(directory, job).stage != JobState::Stage::finished) continue;
      const double cost = results::read_job_cost(directory / job.folder).cpu_seconds;
      const double distance = other.name == setting.name ? -1 : std::abs(std::log(setting.work / other.work));
      if (predicted && distance >= nearest) continue;
      predicted = cost * setting.work / other.work;
      nearest = distance;
    }
  return predicted;
}

std::vector<Variant> variants_of(const std::vector<TriedSetting>& settings) {
  std::vector<Variant> variants;
  for (const TriedSetting& setting : settings)
    if (setting.refused.empty()) variants.push_back(setting.variant);
  return variants;
}

/// Runs what is not finished, cheap settings first and all of them with one seed before any with the next.
void run_settings(const std::string& title, const std::vector<TriedSetting>& settings,
                  const TradeoffOptions& options) {
  std::vector<TriedSetting> order;
  for (const TriedSetting& setting : settings)
    if (setting.refused.empty()) order.push_back(setting);
  std::stable_sort(order.begin(), order.end(),
                   [](const TriedSetting& a, const TriedSetting& b) { return a.work < b.work; });
  const results::JobList list =
      write_jobs(options.directory, {title, variants_of(order), options.seeds, {kCombined}}, options.on_note);
  JobOptions jobs = options.jobs;
  jobs.starts = [&](const results::Job& job, double left) {
    const auto cost =
        predicted_cost(options.directory, settings, options.seeds, setting_called(settings, job.variant));
    return !cost || *cost <= left;
  };
  run_jobs(options.directory, list, jobs);
}

/// Fills in errors against `reference`, and against the maps of its runs.
void judge(results::Tradeoff& tradeoff, std::size_t reference, const TradeoffOptions& options) {
  for (auto& quantity : tradeoff.quantities) {
    const auto target = options.targets.find(quantity.key);
    if (target == options.targets.end()) continue;
    quantity.is_target = true;
    quantity.reference = target->second;
  }
  tradeoff.tolerance = options.tolerance;
  evaluate(tradeoff, reference);
}

/// Every parameter at its cheapest value that alone stays within scatter and tolerance of the base; nothing
/// where fewer than two parameters have one.
std::optional<TriedSetting> combination(const Scene& scene, results::Tradeoff tradeoff,
                                        const std::vector<ParameterValues>& parameters, double tolerance) {
  tradeoff.tolerance = tolerance;
  evaluate(tradeoff, 0);
  if (!distinguishes_settings(tradeoff)) return std::nullopt;
  std::vector<std::pair<Parameter, std::string>> turned;
  for (const results::ParameterRow& row : tradeoff.parameters) {
    double cheapest = kWorthwhile * tradeoff.points.front().core_seconds;
    std::string value;
    for (std::size_t k = 0; k < row.points.size(); ++k) {
      const auto& point = tradeoff.points[row.points[k]];
      if (row.points[k] == 0 || !is_acceptable(point) || !has_enough_seeds(tradeoff, point)) continue;
      if (!(point.core_seconds < cheapest)) continue;
      cheapest = point.core_seconds;
      value = row.values[k];
    }
    const auto parameter =
        std::find_if(parameters.begin(), parameters.end(),
                     [&](const ParameterValues& varied) { return varied.parameter.name == row.name; });
    if (!value.empty()) turned.emplace_back(parameter->parameter, value);
  }
  if (turned.size() < 2) return std::nullopt;
  return setting_with(scene, kCombined, kCombined, turned);
}

void add_remarks(results::Tradeoff& tradeoff, const TradeoffOptions& options) {
  std::string without;
  std::size_t missing = 0;
  for (const auto& point : tradeoff.points) {
    if (point.state == "failed" || point.state == "refused")
      tradeoff.remarks.push_back('"' + point.name + "\" " + point.state + ": " + point.reason);
    else if (point.seeds > 0 && !point.reason.empty())
      tradeoff.remarks.push_back('"' + point.name + "\": a run failed: " + point.reason);
    if (point.state == "failed" || point.state == "refused") continue;
    missing += static_cast<std::size_t>(options.seeds) - static_cast<std::size_t>(point.seeds);
    if (point.seeds == 0) without += (without.empty() ? "" : ", ") + ('"' + point.name + '"');
  }
  if (std::isfinite(options.jobs.cpu_seconds) && missing > 0)
    tradeoff.remarks.push_back(std::to_string(missing) + " runs did not fit the budget of " +
                               number_text(options.jobs.cpu_seconds / 60) + " core minutes" +
                               (without.empty() ? "" : "; no results for " + without) +
                               "; raise --budget to continue");
  for (const auto& point : tradeoff.points)
    if (point.name == kCombined) {
      std::string words = "\"combined\" is";
      for (std::size_t k = 0; k < point.changes.size(); ++k)
        words += (k == 0 ? " " : ", ") + point.changes[k].parameter + '=' + point.changes[k].value;
      tradeoff.remarks.push_back(words);
    }
  if (options.seeds < 2)
    tradeoff.remarks.emplace_back("one seed each: the scatter over seeds is unknown; use --seeds 2");
}

void add_variants(const Scene& scene, std::vector<TriedSetting>& settings) {
  for (TriedSetting& setting : settings_of_variants(scene)) {
    const auto same = [&](const TriedSetting& other) { return other.name == setting.name; };
    if (std::any_of(settings.begin(), settings.end(), same) || setting.name == kCombined)
      throw SceneError(scene.file.string() + ": --variants: variant \"" + setting.name +
                       "\" has the name of another setting; give it a unique name");
    settings.push_back(std::move(setting));
  }
}

std::size_t reference_of(const results::Tradeoff& tradeoff, const std::vector<TriedSetting>& settings,
                         const std::string& wanted) {
  std::vector<int> finer;
  for (std::size_t k = 0; k < settings.size(); ++k) {
    finer.push_back(settings[k].finer);
    if (settings[k].name == wanted && tradeoff.points[k].seeds > 0) return k;
  }
  return reference_setting(tradeoff.points, finer);
}

}  // namespace

TradeoffPlan plan_tradeoff(const Scene& scene, const std::vector<ParameterValues>& parameters,
                           const TradeoffOptions& options) {
  const bool strict = !parameters.empty() || options.variants;
  TradeoffPlan plan;
  plan.parameters = strict ? parameters : usual_parameters(scene);
  plan.settings = one_at_a_time(scene, plan.parameters, strict);
  if (options.variants) add_variants(scene, plan.settings);
  assign_folders(plan.settings);
  check_words(scene, plan.settings, options);
  check_seeds(variants_of(plan.settings), options.seeds);
  return plan;
}

std::vector<std::string> remarks_on_targets(const results::Tradeoff& tradeoff,
                                            const std::map<std::string, double>& targets) {
  std::vector<std::string> remarks;
  for (std::size_t q = 0; q < tradeoff.quantities.size(); ++q) {
    const std::string& key = tradeoff.quantities[q].key;
    const auto has_value = [q](const results::TradeoffPoint& point) {
      return q < point.values.size() && std::isfinite(point.values[q].mean);
    };
    if (targets.contains(key) && std::none_of(tradeoff.points.begin(), tradeoff.points.end(), has_value))
      remarks.push_back("--target " + key +
                        ": no run has a value of this quantity, so the target does not count");
  }
  return remarks;
}

results::Tradeoff trade_off(const Scene& scene, TradeoffPlan plan, const TradeoffOptions& options) {
  auto& settings = plan.settings;
  run_settings(scene.title, settings, options);
  auto tradeoff = gather(options.directory, scene, settings, plan.parameters, options.seeds);
  if (auto combined = combination(scene, tradeoff, plan.parameters, options.tolerance)) {
    settings.push_back(std::move(*combined));
    run_settings(scene.title, settings, options);
    tradeoff = gather(options.directory, scene, settings, plan.parameters, options.seeds);
  }
  tradeoff.command = options.command;
  const std::size_t reference = reference_of(tradeoff, settings, options.reference);
  add_map_correlation(tradeoff, options.directory, settings, options.seeds, reference);
  judge(tradeoff, reference, options);
  add_remarks(tradeoff, options);
  for (auto& remark : remarks_on_targets(tradeoff, options.targets))
    tradeoff.remarks.push_back(std::move(remark));
  return tradeoff;
}

}  // namespace diefill::process
