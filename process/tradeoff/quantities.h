// The quantities by which settings are judged, as numbers of a result.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "process/results/fill_result.h"
#include "process/results/studies/tradeoff.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// A number of a result, in its unit; NaN where the result has none.
struct MeasuredQuantity {
  results::TradeoffQuantity about;
  std::function<double(const results::FillResult&)> value;
};

/// All that the scene can have. Masses of periodic scenes are per length of the slice (per area, where it is
/// periodic along x and y), those of zones per length of the zone within it. To judge by one more figure, its
/// line in quantities.cpp.
std::vector<MeasuredQuantity> measured_quantities(const Scene& scene);

/// Key of the correlation of the density map with that of the reference setting; not in measured_quantities,
/// because it needs both.
inline constexpr const char* kMapCorrelation = "map_correlation";

/// Mean rate (1/s times the column's unit) at which a column of cumulated amounts grew from a fifth to four
/// fifths of its end; NaN where it did not grow.
double steady_rate(const std::vector<double>& time, const std::vector<double>& amount);

}  // namespace diefill::process
