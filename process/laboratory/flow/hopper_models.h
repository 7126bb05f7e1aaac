// What the kinematic models say of a hopper, and what its fields say of theirs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/laboratory/flow/hopper_run.h"

namespace diefill::process::laboratory {

/// m, local B at one node, positive where powder flows as the model says; NaN without a slope. `column` has
/// both its neighbours.
double local_length(const HopperFields& fields, int column, int row);

/// Local B = -v_x / (dv_z/dx) (Bierwisch 2009, Eq. 5.2) at all nodes above the slit's plane where |v_x| is
/// above `least` (m/s) and B is positive, with the solid fraction there; all weights 1.
std::vector<continuum::LengthPoint> local_lengths(const HopperFields& fields, double least);

/// Means of B over classes of solid fraction of equal width; weights are the numbers of nodes.
struct LengthClass {
  double fraction = 0, mean = 0, deviation = 0;  ///< mean and deviation in m
  double count = 0;
};
std::vector<LengthClass> in_classes(const std::vector<continuum::LengthPoint>& points, int classes);

/// Velocities of the model with the fields' own profile in a slit so wide (m), 0 beside it; with a length
/// that depends on the solid fraction also with the fields' fractions (gaps closed with the bulk's).
continuum::HopperFlow solve_for(const HopperFields& fields, double slit,
                                const continuum::DiffusionLength& length, bool compressible);

/// Root of the mean square of model less fields over that of the fields, from z = `from` to `to` (m), where
/// the fields have a value: of the vertical and the horizontal velocity.
struct ModelError {
  double vertical = 0, horizontal = 0;
};
ModelError error_of(const continuum::HopperFlow& flow, const HopperFields& fields, double from, double to);

}  // namespace diefill::process::laboratory
