// The hopper's figures that Bierwisch 2009, chapter 5, has published, by their ids (D01 to D15).
#pragma once

#include <vector>

#include "process/continuum/kinematic_model.h"
#include "process/laboratory/flow/hopper_run.h"
#include "process/results/studies/experiment_result.h"

namespace diefill::process::laboratory {

/// The five set-ups of Table 5.1 with their fields, and the models on the first one's.
struct HopperStudy {
  std::vector<HopperSetup> setups;
  std::vector<HopperFields> fields;
  continuum::LengthOfFraction length;  ///< Eq. 5.5 fitted to the first
  bool length_at_bound = false;        ///< its n_div stands at a bound
  continuum::HopperFlow incompressible, compressible;
};

/// Eq. 5.5 with n_peak = 0.95 `bulk`, the largest solid fraction (Bierwisch 2009, section 5.1.3).
struct FittedLength {
  continuum::LengthOfFraction length;
  bool at_bound = false;  ///< the best n_div lies beyond its bounds
};

/// Fitted to local lengths of powder no denser than the peak. n_div is at most `bulk`, as powder at rest does
/// not flow sideways, and at least so large that B at the peak is no more than `slit` (m): nothing flows in
/// from farther than the stream is wide. B_0 is the best one for the n_div that these bounds leave.
FittedLength fit_rising_branch(const std::vector<continuum::LengthPoint>& points, double bulk, double slit);

/// m, height of the highest row at which the mean fraction above the slit (|x| < D/2) is `share` below that
/// of the rows from 40 mm on (D02); NaN where there is none.
double height_of_loosening(const HopperFields& fields, double slit, double share);

/// m, height of the highest row at which the largest |v_x| is still `share` of that of all rows (D06).
double height_of_side_flow(const HopperFields& fields, double share);

/// Root mean square distance in m of the line v_z = `speed` (m/s, x > 0), from z = `from` to `to` (m), from
/// the straight line through it (D05); NaN where fewer than five rows have the speed. `vertical` has the rows
/// of `grid`.
double bend_of_isoline(const continuum::HopperGrid& grid, const std::vector<double>& vertical, double speed,
                       double from, double to);

/// Largest root mean square difference of a set-up from the mean of all, of v_z or v_x over sqrt(g D) at
/// |x| < D and z = D/4 and D/2, over the largest mean value of that component (D13).
double spread_of_collapse(const HopperStudy& study);

/// D01 to D15. Lengths in D of the source's slit, its effective width.
std::vector<results::ExperimentFigure> hopper_figures(const HopperStudy& study);

}  // namespace diefill::process::laboratory
