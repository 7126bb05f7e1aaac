#include "process/run/stray_watch.h"

#include <cstdio>

#include "process/tooling/half_model.h"

namespace diefill::process {

void StrayWatch::count_removed(const StrayGrain& grain, double time) {
  if (state_.grains == 0) state_ = {0, grain.tool, grain.place, time};
  ++state_.grains;
}

std::optional<std::string> StrayWatch::warning(std::uint64_t poured) const {
  if (state_.grains == 0) return std::nullopt;
  const Eigen::Vector3d place = 1e3 * state_.place;
  const double halves = copies(tooling_);
  char grains[80], where[160];
  std::snprintf(grains, sizeof grains, "%.0f of %.0f", halves * static_cast<double>(state_.grains),
                halves * static_cast<double>(poured));
  std::snprintf(where, sizeof where, "at (%.2f, %.2f, %.2f) mm, t = %.6g s", place[0], place[1], place[2],
                state_.time);
  return std::string(grains) +
         " grains came into tools where no powder was expected and no wall spheres stand, the first into "
         "tool \"" +
         tooling_.tools[state_.tool].spec.name + "\" " + where +
         "; they were removed as spilled: set economy.skip_far_walls = false to cover all surfaces, or pour "
         "the powder so that it does not fall over the rim of its container";
}

}  // namespace diefill::process
