#include <algorithm>
#include <cmath>
#include <limits>

#include "process/measure/figures/counted_grains.h"
#include "process/measure/measure.h"
#include "process/measure/weights.h"

namespace diefill::process {
namespace {

double solid_over_cells(const results::PowderState& powder, const results::GrainSolidFraction& fraction,
                        const std::vector<std::size_t>& grains) {
  double cells = 0;
  for (const std::size_t k : grains) cells += fraction.cell_volume[k];
  return solid_volume(powder, grains) / cells;
}

}  // namespace

results::SolidFractionSummary summarise(const results::PowderState& powder,
                                        const results::GrainSolidFraction& fraction,
                                        const results::CavityState&) {
  const std::vector<std::size_t> grains = counted_grains(powder, fraction, true);
  results::SolidFractionSummary summary;
  summary.grains = grains.size();
  if (grains.empty()) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    summary.mean = summary.arithmetic_mean = summary.std = summary.min = summary.max = summary.cv = none;
    return summary;
  }
  const double count = static_cast<double>(grains.size());
  summary.mean = solid_over_cells(powder, fraction, grains);
  summary.min = summary.max = fraction.solid_fraction[grains.front()];
  for (const std::size_t k : grains) {
    const double value = fraction.solid_fraction[k];
    summary.arithmetic_mean += value / count;
    summary.min = std::min(summary.min, value);
    summary.max = std::max(summary.max, value);
  }
  double squares = 0;
  for (const std::size_t k : grains)
    squares += std::pow(fraction.solid_fraction[k] - summary.arithmetic_mean, 2);
  summary.std = std::sqrt(squares / count);  // every grain is counted, none is a sample of others
  summary.cv = summary.std / summary.arithmetic_mean;
  return summary;
}

double bulk_solid_fraction(const results::PowderState& powder, const results::GrainSolidFraction& fraction) {
  const std::vector<std::size_t> grains = counted_grains(powder, fraction, false);
  return grains.empty() ? std::numeric_limits<double>::quiet_NaN()
                        : solid_over_cells(powder, fraction, grains);
}

}  // namespace diefill::process
