#include "app/pictures/view_extras.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "process/measure/earlier_instant.h"
#include "process/measure/fields/averaging_width.h"
#include "process/measure/fields/gaussian_field.h"
#include "process/measure/tool_solids.h"
#include "render/report/viewer/packed_run.h"

namespace diefill::app {
namespace {

using render::report::DensityGrid;

constexpr double kPointsAlong = 70;         // of the longest side
constexpr double kSpacingOverWidth = 0.35;  // of the averaging width: finer shows nothing more

/// Round all cavities; empty where there are none.
Eigen::AlignedBox3d cavity_box(const results::FillResult& result) {
  Eigen::AlignedBox3d box;
  const auto add = [&](const results::CavityState& cavity) {
    if (cavity.volume > 0) box.extend(Eigen::AlignedBox3d(cavity.lower_corner, cavity.upper_corner));
  };
  add(result.cavity);
  for (const auto& other : result.other_cavities) add(other);
  return box;
}

DensityGrid density_over(const results::FillResult& result, const Eigen::AlignedBox3d& box) {
  DensityGrid grid;
  grid.averaging_width = process::usual_averaging_width(result);
  grid.spacing = std::max(box.sizes().maxCoeff() / kPointsAlong, kSpacingOverWidth * grid.averaging_width);
  grid.origin = box.min();
  grid.counts = (box.sizes() / grid.spacing).array().ceil().cast<int>() + 1;
  const process::GaussianField field(result.powder, result.solid_fraction, grid.averaging_width);
  const auto tools = process::solids_of(result.tools);
  const auto in_a_tool = [&](const Eigen::Vector3d& point) {
    return std::any_of(tools.begin(), tools.end(), [&](const auto& tool) { return tool.inside(point); });
  };
  for (int z = 0; z < grid.counts.z(); ++z)
    for (int y = 0; y < grid.counts.y(); ++y)
      for (int x = 0; x < grid.counts.x(); ++x) {
        const Eigen::Vector3d point = grid.origin + grid.spacing * Eigen::Vector3d(x, y, z);
        const double value = field.at(point);
        grid.value.push_back(std::isfinite(value) && in_a_tool(point) ? std::nan("") : value);
      }
  return grid;
}

std::vector<double> closed_fractions(const results::GrainSolidFraction& measured) {
  std::vector<double> values = measured.solid_fraction;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (measured.open[k] != 0) values[k] = std::nan("");
  return values;
}

}  // namespace

render::report::ViewExtras view_extras(const results::FillResult& result,
                                       const process::ProgressCallback& on_progress) {
  render::report::ViewExtras extras;
  const auto box = cavity_box(result);
  if (!box.isEmpty() && !result.powder.position.empty() && !result.solid_fraction.open.empty())
    extras.density = density_over(result, box);
  const std::size_t most = render::report::PackingLimits{}.instants;
  const auto shown = render::report::spread_instants(result.instants.size(), most);
  for (const std::size_t n : shown) {
    on_progress(static_cast<double>(extras.fractions.size()) / static_cast<double>(shown.size()),
                "measuring instant " + std::to_string(extras.fractions.size() + 1) + " of " +
                    std::to_string(shown.size()));
    const auto then = process::result_at(result, result.instants[n].time);
    extras.fractions.push_back({n, closed_fractions(then.solid_fraction)});
  }
  return extras;
}

}  // namespace diefill::app
