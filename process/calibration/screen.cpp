#include "process/calibration/screen.h"

#include <stdexcept>

#include "process/calibration/calibration_results.h"
#include "process/calibration/methods/effect_regression.h"
#include "process/calibration/methods/screening_effects.h"
#include "process/input/units.h"
#include "process/results/rounding.h"
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

/// Responses of one value over the design, seed by seed; empty where a run has none.
std::vector<std::vector<double>> responses_of(std::size_t measurement, std::size_t value,
                                              const SimulatedPoints& simulated) {
  std::vector<std::vector<double>> responses;
  for (const PointOutcome& outcome : simulated.outcomes) {
    if (!outcome.has(measurement)) return {};
    responses.emplace_back();
    for (const auto& row : outcome.values[measurement]) responses.back().push_back(row[value]);
  }
  return responses;
}

std::vector<double> means_of(const std::vector<std::vector<double>>& responses) {
  std::vector<double> means;
  for (const auto& values : responses) {
    double sum = 0;
    for (const double value : values) sum += value;
    means.push_back(sum / static_cast<double>(values.size()));
  }
  return means;
}

/// Names of what a string stands for, such as "powder.friction" or "a with b".
std::string words_of(const AliasString& string, const CalibrationPlan& plan) {
  std::string words;
  for (const std::size_t k : string.factors) words += (words.empty() ? "" : " = ") + plan.parameters[k].key;
  for (const auto& [i, j] : string.pairs)
    words += (words.empty() ? "" : " = ") + plan.parameters[i].key + " with " + plan.parameters[j].key;
  return words;
}

std::string source_text(ErrorSource source) {
  if (source == ErrorSource::repeats) return "runs with other seeds";
  if (source == ErrorSource::lenth) return "the smaller effects (Lenth 1989); one seed each";
  return "nothing: too few runs; use two seeds or more";
}

void add_quantity(results::Screening& screening, const FractionalDesign& design, const std::string& name,
                  const std::string& unit, const std::vector<std::vector<double>>& responses) {
  const ScreeningEffects found = screening_effects(design, responses);
  const auto means = means_of(responses);
  const std::vector<FactorRange> levels(design.factors(), FactorRange{-1, 1});
  const EffectModel model = fit_effects(design, levels, means, pairs_to_fit(design, means));
  const auto settings = settings_of(design, levels);
  screening.quantities.push_back({name, unit, found.mean, found.error, found.margin,
                                  prediction_error(model, settings, means, false),
                                  prediction_error(model, settings, means, true)});
  screening.error_source = source_text(found.source);
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
    screening.effects.push_back({text_of(string), words_of(string, plan), !string.factors.empty(), {}});
  for (std::size_t m = 0; m < plan.measurements.size(); ++m) {
    const Measurement& measurement = plan.measurements[m];
    if (!measurement.fitted) continue;
    for (std::size_t value = 0; value < measurement.data.size(); ++value) {
      const auto responses = responses_of(m, value, simulated);
      if (!responses.empty())
        add_quantity(screening, design, name_of(measurement, value), measurement.data.value.unit, responses);
    }
  }
  return screening;
}

results::Calibration screen(const CalibrationPlan& plan, const CalibrateOptions& options) {
  const FractionalDesign design = design_for(plan);
  SimulatedPoints simulated{corners(design), {}};
  PointRuns runs(plan, options.points);
  runs.run(simulated.points);
  for (std::size_t k = 0; k < simulated.points.size(); ++k)
    simulated.outcomes.push_back(runs.outcome(simulated.points[k], k));
  results::Calibration account = calibration_results(plan, simulated, std::nullopt);
  account.command = options.command;
  account.program_version = program_version();
  account.screening = screening_of(plan, design, simulated);
  account.stopped = runs.over_budget() ? "the budget is used" : "the design is complete";
  if (account.screening.quantities.empty())
    account.remarks.emplace_back("no quantity has values at all runs of the design: there are no effects");
  return account;
}

}  // namespace diefill::process::calibration
