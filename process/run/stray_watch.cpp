#include "process/run/stray_watch.h"

#include <cstdio>

#include "process/tooling/half_model.h"

namespace diefill::process {

namespace {

/// A mesh is closed: only a grain that passes through it comes into its tool.
const char* remedy(const Tool& tool) {
  return tool.wall_mesh
             ? "reduce the speed of the tools or the height from which powder falls onto this one, "
               "whose wall is its mesh, or make the contacts stiffer"
             : "set economy.skip_far_walls = false to cover all surfaces, or pour the powder so "
               "that it does not fall over the rim of its container";
}

}  // namespace

void StrayWatch::count_removed(const StrayGrain& grain, double time) {
  if (state_.grains == 0) state_ = {0, grain.tool, grain.place, time};
  ++state_.grains;
}

std::optional<std::string> StrayWatch::warning(std::uint64_t poured) const {
  if (state_.grains == 0) return std::nullopt;
  const Eigen::Vector3d place = 1e3 * state_.place;
  const Tool& first = tooling_.tools[state_.tool];
  const double halves = copies(tooling_);
  char grains[80], where[160];
  std::snprintf(grains, sizeof grains, "%.0f of %.0f", halves * static_cast<double>(state_.grains),
                halves * static_cast<double>(poured));
  std::snprintf(where, sizeof where, "at (%.2f, %.2f, %.2f) mm, t = %.6g s", place[0], place[1], place[2],
                state_.time);
  return std::string(grains) + " grains came into tools where no powder was expected" +
         (first.wall_mesh ? "" : " and no wall spheres stand") + ", the first into tool \"" +
         first.spec.name + "\" " + where + "; they were removed as spilled: " + remedy(first);
}

}  // namespace diefill::process
