#include "process/calibration/screen.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "process/calibration/calibration_results.h"
#include "process/calibration/methods/effect_regression.h"
#include "process/calibration/methods/screening_effects.h"
#include "process/input/units.h"
#include "process/results/rounding.h"
#include "process/results/studies/mean.h"
#include "process/results/word_list.h"
#include "process/run/assemble.h"

namespace diefill::process::calibration {
namespace {

FractionalDesign design_for(const CalibrationPlan& plan) {
  try {
    return compact_design(plan.parameters.size(), static_cast<std::size_t>(plan.resolution));
  } catch (const std::invalid_argument& error) {
    throw SceneError(plan.file.string() + ": screening: " + error.what() +
                     "; screen fewer parameters at a time");
  }
}

std::vector<Point> corners(const FractionalDesign& design) {
  std::vector<Point> points;
  for (std::size_t run = 0; run < design.runs(); ++run) {
    Point point{"screening", {}};
    for (std::size_t k = 0; k < design.factors(); ++k)
      point.place.push_back(level(design, run, k) > 0 ? 1 : 0);
    points.push_back(std::move(point));
  }
  return points;
}

std::string name_of(const Measurement& measurement, std::size_t value) {
  if (measurement.data.places.empty()) return measurement.name;
  std::string name = measurement.name + " at ";
  for (std::size_t p = 0; p < measurement.data.places.size(); ++p) {
    const MeasuredColumn& place = measurement.data.places[p];
    name += (p == 0 ? "" : ", ") + number_text(place.values[value]) + results::unit_behind(place.unit);
  }
  return name;
}

/// A scene that a corner cannot have would take away all effects: it is named before hours are spent.
void check_corners(const CalibrationPlan& plan, const std::vector<Point>& points) {
  for (std::size_t run = 0; run < points.size(); ++run)
    for (const Measurement& measurement : plan.measurements) {
      if (!measurement.fitted) continue;
      try {
        for (const MeasurementRun& each : measurement.runs) scene_at(plan, each, points[run].place);
      } catch (const SceneError& error) {
        std::string setting;
        for (std::size_t k = 0; k < plan.parameters.size(); ++k)
          setting += (k == 0 ? "" : ", ") + plan.parameters[k].key + " = " +
                     number_text(plan.parameters[k].value_at(points[run].place[k]));
        throw SceneError(std::string(error.what()) + " (measurement \"" + measurement.name + "\", run " +
                         std::to_string(run + 1) + " of the screening: " + setting + ")");
      }
    }
}

/// Responses of one value over the design, seed by seed; none for a run without a value.
std::vector<std::vector<double>> responses_of(std::size_t measurement, std::size_t value,
                                              const SimulatedPoints& simulated) {
  std::vector<std::vector<double>> responses;
  for (const PointOutcome& outcome : simulated.outcomes) {
    responses.emplace_back();
    for (const auto& row : outcome.values[measurement])
      if (std::isfinite(row[value])) responses.back().push_back(row[value]);
  }
  return responses;
}

/// Why a quantity has no effects: the runs without a value of it; empty where all have one.
std::string without_value(const std::string& name, const std::vector<std::vector<double>>& responses,
                          const SimulatedPoints& simulated) {
  constexpr std::size_t kMaxNamed = 4;
  std::vector<std::string> runs;
  for (std::size_t run = 0; run < responses.size(); ++run) {
    const std::string& reason = simulated.outcomes[run].reason;
    if (responses[run].empty())
      runs.push_back("run " + std::to_string(run + 1) + (reason.empty() ? "" : " (" + reason + ')'));
  }
  if (runs.empty()) return {};
  return "no effects on " + name + ", which has no value in " + results::comma_list(runs, kMaxNamed);
}

std::vector<double> means_of(const std::vector<std::vector<double>>& responses) {
  std::vector<double> means;
  for (const auto& values : responses) means.push_back(results::mean_of(values));
  return means;
}

/// Names of what a string stands for, such as "powder.friction" or "a with b".
std::string factor_names(const AliasString& string, const CalibrationPlan& plan) {
  std::string words;
  for (const std::size_t k : string.factors) words += (words.empty() ? "" : " = ") + plan.parameters[k].key;
  for (const auto& [i, j] : string.pairs)
    words += (words.empty() ? "" : " = ") + plan.parameters[i].key + " with " + plan.parameters[j].key;
  return words;
}

std::string source_text(ErrorSource source) {
  if (source == ErrorSource::repeats) return "runs with other seeds";
  if (source == ErrorSource::lenth) return "the smaller effects (Lenth 1989); one seed each";
  if (source == ErrorSource::zeros)
    return "nothing: more than half of the effects are 0; use two seeds or more";
  return "nothing: too few runs; use two seeds or more";
}

/// Where the standard errors of all quantities come from; of several sources, which quantities each is for.
std::string common_source(const std::vector<results::ScreenedQuantity>& quantities) {
  constexpr std::size_t kMaxOfOne = 4;
  std::vector<std::string> sources;
  for (const auto& quantity : quantities)
    if (std::find(sources.begin(), sources.end(), quantity.error_source) == sources.end())
      sources.push_back(quantity.error_source);
  if (sources.size() == 1) return sources.front();
  std::string text;
  for (const std::string& source : sources) {
    std::vector<std::string> names;
    for (const auto& quantity : quantities)
      if (quantity.error_source == source) names.push_back(quantity.name);
    text += (text.empty() ? "" : "; ") + source + " (" + results::comma_list(names, kMaxOfOne) + ')';
  }
  return text;
}

/// y = mean + sum of coefficients times levels, which are -1 and 1: with these each is half an effect.
std::vector<results::RegressionTerm> terms_of(const EffectModel& model) {
  std::vector<results::RegressionTerm> terms;
  for (std::size_t k = 0; k < model.coefficient.size(); ++k)
    terms.push_back({factor_letter(k), model.coefficient[k]});
  for (const PairTerm& term : model.pairs)
    terms.push_back({factor_letter(term.pair.first) + factor_letter(term.pair.second), term.coefficient});
  return terms;
}

void add_quantity(results::Screening& screening, const FractionalDesign& design, const std::string& name,
                  const std::string& unit, const std::vector<std::vector<double>>& responses) {
  const ScreeningEffects found = screening_effects(design, responses);
  const auto means = means_of(responses);
  const std::vector<FactorRange> levels(design.factors(), FactorRange{-1, 1});
  const EffectModel model = fit_effects(design, levels, means, pairs_to_fit(design, means));
  const auto settings = settings_of(design, levels);
  screening.quantities.push_back(
      {name, unit, found.mean, found.error, found.margin, prediction_error(model, settings, means, false),
       prediction_error(model, settings, means, true), terms_of(model), source_text(found.source)});
  if (!have_one_sign(means))
    screening.remarks.push_back("no relative error of the regression of " + name +
                                ", which is 0 or changes its sign over the design");
  for (std::size_t k = 0; k < found.effects.size(); ++k)
    screening.effects[k].values.push_back(found.effects[k].value);
}

}  // namespace

results::Screening screening_of(const CalibrationPlan& plan, const FractionalDesign& design,
                                const SimulatedPoints& simulated) {
  constexpr std::size_t kMaxGenerators = 12;  // whose words are few enough to read
  results::Screening screening;
  screening.runs = design.runs();
  screening.resolution = resolution_of(design);
  for (std::size_t k = 0; k < design.factors(); ++k)
    screening.letters.push_back(factor_letter(k) + " = " + plan.parameters[k].key);
  screening.generators = generators_of(design);
  if (screening.generators.size() <= kMaxGenerators) screening.words = defining_words(design);
  for (const AliasString& string : alias_strings(design))
    screening.effects.push_back({text_of(string), factor_names(string, plan), !string.factors.empty(), {}});
  for (std::size_t m = 0; m < plan.measurements.size(); ++m) {
    const Measurement& measurement = plan.measurements[m];
    if (!measurement.fitted) continue;
    for (std::size_t value = 0; value < measurement.data.size(); ++value) {
      const auto responses = responses_of(m, value, simulated);
      const std::string name = name_of(measurement, value);
      if (const std::string reason = without_value(name, responses, simulated); !reason.empty())
        screening.remarks.push_back(reason);
      else
        add_quantity(screening, design, name, measurement.data.value.unit, responses);
    }
  }
  screening.error_source = common_source(screening.quantities);
  return screening;
}

results::Calibration screen(const CalibrationPlan& plan, const CalibrateOptions& options) {
  const FractionalDesign design = design_for(plan);
  SimulatedPoints simulated{corners(design), {}};
  check_corners(plan, simulated.points);
  PointRuns runs(plan, options.points);
  runs.run(simulated.points);
  for (std::size_t k = 0; k < simulated.points.size(); ++k)
    simulated.outcomes.push_back(runs.outcome(simulated.points[k], k));
  results::Calibration account = calibration_results(plan, simulated, std::nullopt);
  account.command = options.command;
  account.program_version = program_version();
  account.screening = screening_of(plan, design, simulated);
  account.remarks.insert(account.remarks.end(), account.screening.remarks.begin(),
                         account.screening.remarks.end());
  account.stopped = runs.over_budget() ? "the budget is used" : "the design is complete";
  if (account.screening.quantities.empty())
    account.remarks.emplace_back("no quantity has values at all runs of the design: there are no effects");
  return account;
}

}  // namespace diefill::process::calibration
