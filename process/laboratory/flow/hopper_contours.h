// Lines of equal velocity and solid fraction above the hopper's slit, DEM against both kinematic models
// (Bierwisch 2009, section 5.1).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "process/laboratory/flow/hopper_charts.h"

namespace diefill::process::laboratory {

/// Lines x, z (m) along which `field`, of the columns and levels of `grid`, has the value `level`, linear
/// between its nodes. A closed line ends at its first point. None where a node beside it is NaN.
std::vector<std::vector<Eigen::Vector2d>> contour_lines(const continuum::HopperGrid& grid,
                                                        const std::vector<double>& field, double level);

/// Contours of v_z, v_x and the solid fraction over x and z.
void add_contour_charts(const HopperFields& fields, const HopperModels& models,
                        std::vector<results::ExperimentChart>& charts);

}  // namespace diefill::process::laboratory
