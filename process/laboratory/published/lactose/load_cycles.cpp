#include "process/laboratory/published/lactose/load_cycles.h"

#include <algorithm>
#include <numeric>

#include "process/results/none.h"

namespace diefill::process::laboratory {
namespace {

/// The first row from `from` on whose stress is at least (`rising`) or at most `stress`.
std::size_t reach(const LoadCurve& curve, std::size_t from, double stress, bool rising) {
  for (std::size_t k = from; k < curve.stress.size(); ++k)
    if (rising ? curve.stress[k] >= stress : curve.stress[k] <= stress) return k;
  return curve.stress.size();
}

/// m, where the curve crosses `stress` between rows k - 1 and k.
double height_at(const LoadCurve& curve, std::size_t k, double stress) {
  if (k == 0 || k >= curve.stress.size()) return kNone;
  const double share = (stress - curve.stress[k - 1]) / (curve.stress[k] - curve.stress[k - 1]);
  return curve.height[k - 1] + share * (curve.height[k] - curve.height[k - 1]);
}

}  // namespace

Stiffness stiffness_of(const LoadCurve& curve, const LoadCycle& loads) {
  constexpr double kWithin = 0.01;
  // Rows are means over a time: none need show a load that was reached for an instant.
  constexpr double kShown = 0.98, kLeft = 0.97, kNearLow = 1.1;
  Stiffness found;
  std::size_t k = reach(curve, 0, (1 - kWithin) * loads.high, true);
  if (k >= curve.stress.size()) return found;
  const double first = curve.height[k];
  found.beta = (curve.height.front() - first) / curve.height.front();
  double loading = 0, unloading = 0;
  for (int cycle = 0; cycle < loads.cycles; ++cycle) {
    // The place and load from which it unloads: the last row near the high load.
    const std::size_t down = reach(curve, k, kLeft * loads.high, false);
    const std::size_t half_down = reach(curve, down, loads.half, false);
    const std::size_t low = reach(curve, half_down, kNearLow * loads.low, false);
    const std::size_t up = reach(curve, low, kNearLow * loads.low, true);
    const std::size_t half_up = reach(curve, up, loads.half, true);
    if (half_up >= curve.stress.size()) return {found.beta, kNone, kNone};
    unloading += (curve.stress[down - 1] - loads.half) * first /
                 (height_at(curve, half_down, loads.half) - curve.height[down - 1]);
    loading += (loads.half - curve.stress[up - 1]) * first /
               (curve.height[up - 1] - height_at(curve, half_up, loads.half));
    k = reach(curve, half_up, kShown * loads.high, true);
  }
  found.loading = loading / loads.cycles;
  found.unloading = unloading / loads.cycles;
  return found;
}

Tension tension_of(const PullCurve& curve) {
  constexpr std::size_t kMin = 20;
  const auto rows = curve.pull.size();
  if (rows < kMin) return {};
  const auto last = static_cast<std::ptrdiff_t>(rows / kMin);
  const double weight =
      std::accumulate(curve.pull.end() - last, curve.pull.end(), 0.0) / static_cast<double>(last);
  const auto peak = std::max_element(curve.pull.begin(), curve.pull.end());
  Tension tension;
  tension.strength = *peak - weight;
  auto end = curve.pull.end();
  while (end != peak && *(end - 1) - weight < 0.1 * tension.strength) --end;
  const auto place = [&](auto row) {
    return curve.travel[static_cast<std::size_t>(row - curve.pull.begin())];
  };
  if (end != curve.pull.end()) tension.fracture = place(end) - place(peak);
  return tension;
}

}  // namespace diefill::process::laboratory
