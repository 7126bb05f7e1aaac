// Zones of a part, such as flange and hub: what of the powder lies in them, as figures.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// A named part of the cavities: a box, the space between two cylinders about a vertical axis, a range of
/// heights, or what several of them have in common. Limits that are not given are infinite.
struct Zone {
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  std::string name;
  Eigen::Vector3d lower = Eigen::Vector3d::Constant(-kFar), upper = Eigen::Vector3d::Constant(kFar);  ///< m
  Eigen::Vector2d axis = Eigen::Vector2d::Zero();  ///< m, place of the cylinders' axis
  double inner_radius = 0, outer_radius = kFar;    ///< m

  bool contains(const Eigen::Vector3d& point) const;
};

/// Sets the figures of every zone: `filled_mass_in_<zone>_kg`, the mass of the grains of the
/// cavities whose centre lies in it; `mass_share_in_<zone>`, of all powder in the cavities; and
/// `solid_fraction_in_<zone>`, the solid volume over the cell volume of those with a closed cell (as the mean
/// solid fraction of the summary, but up to the powder surface). Without a cavity all powder counts. The
/// solid fraction has no value, with the reason, on too few grains (enough_grains.h).
void add_zone_figures(results::FillResult& result, const std::vector<Zone>& zones);

/// Names of these figures.
std::string zone_mass_figure(const std::string& zone);
std::string zone_share_figure(const std::string& zone);
std::string zone_solid_fraction_figure(const std::string& zone);

}  // namespace diefill::process
