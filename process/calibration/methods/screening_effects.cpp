#include "process/calibration/methods/screening_effects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "process/results/studies/mean.h"
#include "process/results/studies/median.h"
#include "process/results/studies/quantiles.h"

namespace diefill::process::calibration {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// From repeats: variance within settings, pooled, carried over to a difference of two means.
void error_from_repeats(ScreeningEffects& screening, const std::vector<std::vector<double>>& responses) {
  double squares = 0, freedom = 0, of_means = 0;
  for (const auto& values : responses) {
    const double mean = results::mean_of(values);
    for (const double value : values) squares += (value - mean) * (value - mean);
    freedom += static_cast<double>(values.size() - 1);
    of_means += 1 / static_cast<double>(values.size());
  }
  const double runs = static_cast<double>(responses.size());
  screening.source = ErrorSource::repeats;
  screening.error = 2 / runs * std::sqrt(squares / freedom * of_means);
  screening.margin = results::student_95(freedom) * screening.error;
}

/// Contrasts that rounding alone makes of zero ones.
double round_off(const std::vector<double>& means) {
  constexpr double kRoundOff = 1e-12;
  double largest = 0;
  for (const double mean : means) largest = std::max(largest, std::abs(mean));
  return kRoundOff * largest;
}

void error_after_lenth(ScreeningEffects& screening, const FractionalDesign& design,
                       const std::vector<double>& means) {
  constexpr std::size_t kMin = 7;
  std::vector<double> sizes;
  for (std::uint64_t column = 1; column < design.runs(); ++column)
    sizes.push_back(std::abs(contrast(design, means, column)));
  screening.error = screening.margin = kNone;
  if (sizes.size() < kMin) return;
  const double median = results::median(sizes);
  if (median <= round_off(means)) {
    screening.source = ErrorSource::zeros;
    return;
  }
  const double first = 1.5 * median;
  std::vector<double> small;
  for (const double size : sizes)
    if (size < 2.5 * first) small.push_back(size);
  screening.source = ErrorSource::lenth;
  screening.error = 1.5 * results::median(small);
  screening.margin = results::student_95(static_cast<double>(sizes.size()) / 3) * screening.error;
}

}  // namespace

double contrast(const FractionalDesign& design, const std::vector<double>& means, std::uint64_t column) {
  double sum = 0;
  for (std::size_t run = 0; run < design.runs(); ++run)
    sum += level_of_column(design, run, column) * means[run];
  return 2 * sum / static_cast<double>(design.runs());
}

ScreeningEffects screening_effects(const FractionalDesign& design,
                                   const std::vector<std::vector<double>>& responses) {
  if (responses.size() != design.runs())
    throw std::invalid_argument("a design of " + std::to_string(design.runs()) + " runs has " +
                                std::to_string(responses.size()) + " responses");
  std::vector<double> means;
  bool repeated = false;
  for (const auto& values : responses) {
    if (values.empty()) throw std::invalid_argument("a run of the design has no response");
    means.push_back(results::mean_of(values));
    repeated = repeated || values.size() > 1;
  }
  ScreeningEffects screening;
  screening.mean = results::mean_of(means);
  for (AliasString& string : alias_strings(design)) {
    const double value = contrast(design, means, string.column);
    screening.effects.push_back({std::move(string), value});
  }
  if (repeated)
    error_from_repeats(screening, responses);
  else
    error_after_lenth(screening, design, means);
  return screening;
}

}  // namespace diefill::process::calibration
