#include "process/results/storage/shown_instants.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "process/results/instant_powder.h"
#include "process/results/storage/group_names.h"

namespace diefill::results {
namespace {

constexpr double kCellOverDiameter = 1.5;
constexpr double kMaxCells = 1e6;
constexpr double kRounding = 1e-9;  // m: a tool that moved less stands where it stood

/// Empty where the tool has not moved.
std::vector<Eigen::Vector3d> moved_vertices(const ToolState& tool, const Instant& instant,
                                            std::size_t number) {
  const Eigen::Vector4d& turn = instant.tool_orientation[number];
  const Eigen::Matrix3d rotation = Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3]).toRotationMatrix();
  std::vector<Eigen::Vector3d> vertices;
  double farthest = 0;
  for (const auto& vertex : tool.vertices) {
    vertices.emplace_back(rotation * vertex + instant.tool_displacement[number]);
    farthest = std::max(farthest, (vertices.back() - vertex).cwiseAbs().maxCoeff());
  }
  if (farthest < kRounding) vertices.clear();
  return vertices;
}

/// Shares a volume at a point among the cells whose middles are around it.
void share(const ShownGrid& grid, const Eigen::Vector3d& place, double volume, std::vector<double>& values) {
  const Eigen::Vector3d at = (place - grid.origin) / grid.spacing -
                             Eigen::Vector3d::Constant(0.5);  // in cells, from the first middle
  const Eigen::Vector3d below = at.array().floor();
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::size_t cell = 0, stride = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const bool upper = (corner >> axis & 1) != 0;
      const double step = at[axis] - below[axis];
      const double number = below[axis] + (upper ? 1 : 0);
      const auto cells = static_cast<double>(grid.cells[static_cast<std::size_t>(axis)]);
      if (number < 0 || number >= cells) {
        weight = 0;
        break;
      }
      weight *= upper ? step : 1 - step;
      cell += stride * static_cast<std::size_t>(number);
      stride *= grid.cells[static_cast<std::size_t>(axis)];
    }
    if (weight > 0) values[cell] += weight * volume;
  }
}

std::vector<double> solid_share(const PowderState& powder, const ShownGrid& grid) {
  std::vector<double> values(grid.size(), 0.0);
  if (values.empty() || powder.orientation.size() != powder.position.size()) return values;
  const auto centres = powder.sphere_centres();
  const auto radii = powder.radii_of_spheres();
  const auto grains = powder.grains_of_spheres();
  std::vector<double> cubes(powder.position.size(), 0.0);
  for (std::size_t n = 0; n < centres.size(); ++n) cubes[grains[n]] += std::pow(radii[n], 3);
  const double cell = std::pow(grid.spacing, 3);
  for (std::size_t n = 0; n < centres.size(); ++n)
    share(grid, centres[n],
          powder.solid_volume_of(grains[n]) * std::pow(radii[n], 3) / cubes[grains[n]] / cell, values);
  return values;
}

ShownInstant shown(const PowderState& powder, const std::string& group, const ShownGrid& grid) {
  ShownInstant instant;
  instant.time = powder.time;
  instant.powder = group;
  instant.grains = powder.position.size();
  for (std::size_t k = 0; k < instant.grains; ++k) instant.diameter.push_back(powder.diameter_of(k));
  instant.solid_share = solid_share(powder, grid);
  return instant;
}

}  // namespace

ShownGrid shown_grid(const FillResult& result) {
  ShownGrid grid;
  const Eigen::Vector3d size = result.cavity.upper_corner - result.cavity.lower_corner;
  if (!(size.minCoeff() > 0) || !(result.powder.grain_diameter > 0)) return grid;
  grid.spacing =
      std::max(kCellOverDiameter * result.powder.largest_diameter(), std::cbrt(size.prod() / kMaxCells));
  const Eigen::Vector3d cells = (size / grid.spacing).array().ceil();
  for (int axis = 0; axis < 3; ++axis)
    grid.cells[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(cells[axis]);
  grid.origin = result.cavity.lower_corner;
  return grid;
}

std::vector<std::string> shown_names(const FillResult& result) {
  std::vector<std::string> names(result.instants.size(), "instant");
  names.emplace_back("end");
  return group_names(names);
}

std::vector<ShownInstant> shown_instants(const FillResult& result, const ShownGrid& grid) {
  const auto names = shown_names(result);
  std::vector<ShownInstant> all;
  for (std::size_t n = 0; n < result.instants.size(); ++n) {
    const Instant& instant = result.instants[n];
    all.push_back(shown(powder_at(result.powder, instant), "/instants/" + names[n], grid));
    for (std::size_t t = 0; t < result.tools.size(); ++t)
      all.back().vertices.push_back(moved_vertices(result.tools[t], instant, t));
  }
  all.push_back(shown(result.powder, "/powder", grid));
  all.back().vertices.resize(result.tools.size());
  return all;
}

}  // namespace diefill::results
