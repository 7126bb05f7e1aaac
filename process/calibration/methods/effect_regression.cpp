#include "process/calibration/methods/effect_regression.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "process/calibration/methods/screening_effects.h"

namespace diefill::process::calibration {
namespace {

void check(const FractionalDesign& design, const std::vector<FactorRange>& ranges,
           const std::vector<double>& responses) {
  if (ranges.size() != design.factors() || responses.size() != design.runs())
    throw std::invalid_argument("a design needs a range for each factor and a response for each run");
  for (const FactorRange& range : ranges)
    if (!(range.high > range.low))
      throw std::invalid_argument("a factor has its high level above its low one");
}

}  // namespace

std::vector<FactorPair> pairs_to_fit(const FractionalDesign& design, const std::vector<double>& responses) {
  std::vector<FactorPair> chosen;
  for (const AliasString& string : alias_strings(design)) {
    if (!string.factors.empty()) continue;
    const auto product = [&](const FactorPair& pair) {
      return std::abs(contrast(design, responses, design.columns[pair.first]) *
                      contrast(design, responses, design.columns[pair.second]));
    };
    FactorPair best = string.pairs.front();
    for (const FactorPair& pair : string.pairs)
      if (product(pair) > product(best)) best = pair;
    chosen.push_back(best);
  }
  return chosen;
}

double pair_effect(const FractionalDesign& design, const std::vector<double>& responses,
                   const FactorPair& pair) {
  double sum[2][2] = {}, runs[2][2] = {};
  for (std::size_t run = 0; run < design.runs(); ++run) {
    const int i = level(design, run, pair.first) > 0 ? 1 : 0, j = level(design, run, pair.second) > 0 ? 1 : 0;
    sum[i][j] += responses[run];
    runs[i][j] += 1;
  }
  return (sum[1][1] / runs[1][1] - sum[0][1] / runs[0][1]) -
         (sum[1][0] / runs[1][0] - sum[0][0] / runs[0][0]);
}

EffectModel fit_effects(const FractionalDesign& design, const std::vector<FactorRange>& ranges,
                        const std::vector<double>& responses, const std::vector<FactorPair>& pairs) {
  check(design, ranges, responses);
  EffectModel model;
  for (const double response : responses) model.mean += response / static_cast<double>(responses.size());
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    model.centre.push_back(0.5 * (ranges[k].low + ranges[k].high));
    model.coefficient.push_back(contrast(design, responses, design.columns[k]) /
                                (ranges[k].high - ranges[k].low));
  }
  for (const FactorPair& pair : pairs) {
    const FactorRange &first = ranges[pair.first], &second = ranges[pair.second];
    model.pairs.push_back({pair, pair_effect(design, responses, pair) /
                                     ((first.high - first.low) * (second.high - second.low))});
  }
  return model;
}

double predicted(const EffectModel& model, const std::vector<double>& setting, bool interactions) {
  double value = model.mean;
  const auto offset = [&](std::size_t k) { return setting[k] - model.centre[k]; };
  for (std::size_t k = 0; k < setting.size(); ++k) value += model.coefficient[k] * offset(k);
  if (!interactions) return value;
  for (const PairTerm& term : model.pairs)
    value += term.coefficient * offset(term.pair.first) * offset(term.pair.second);
  return value;
}

bool have_one_sign(const std::vector<double>& responses) {
  const auto all = [&](double sign) {
    return std::all_of(responses.begin(), responses.end(), [&](double value) { return sign * value > 0; });
  };
  return all(1) || all(-1);
}

double prediction_error(const EffectModel& model, const std::vector<std::vector<double>>& settings,
                        const std::vector<double>& responses, bool interactions) {
  if (!have_one_sign(responses)) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (std::size_t run = 0; run < settings.size(); ++run)
    sum +=
        std::abs(predicted(model, settings[run], interactions) - responses[run]) / std::abs(responses[run]);
  return 100 * sum / static_cast<double>(settings.size());
}

std::vector<std::vector<double>> settings_of(const FractionalDesign& design,
                                             const std::vector<FactorRange>& ranges) {
  std::vector<std::vector<double>> settings(design.runs());
  for (std::size_t run = 0; run < design.runs(); ++run)
    for (std::size_t k = 0; k < ranges.size(); ++k)
      settings[run].push_back(level(design, run, k) > 0 ? ranges[k].high : ranges[k].low);
  return settings;
}

}  // namespace diefill::process::calibration
