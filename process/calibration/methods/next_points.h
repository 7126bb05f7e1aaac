// Where the next simulations help most, and whether any still does.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "process/calibration/methods/likelihood.h"
#include "process/calibration/methods/region.h"

namespace diefill::process::calibration {

/// Expected improvement at a place: mean over what the emulators do not know of how far the misfit falls
/// below `best` (Jones, Schonlau and Welch 1998, by draws, since a sum of squares is not normal).
double expected_improvement(const Likelihood& likelihood, const Eigen::VectorXd& place, double best);

/// Standard deviation of the misfit at a place over seeds, were the runs there repeated. The quantities of a
/// measurement scatter together as the emulator's covariance says: those of one run are not independent.
double misfit_scatter(const Likelihood& likelihood, const Eigen::VectorXd& place);

/// Mean over the region of the emulators' variance over the measurements': how much of the uncertainty comes
/// from simulations too few.
double mean_emulator_share(const Likelihood& likelihood, const Region& region);

struct NextPoints {
  /// First where the improvement expected is largest; second where, within the region that agrees, the
  /// emulators know least; and so on in turn.
  std::vector<Eigen::VectorXd> places;
  double expected_gain = 0;   ///< largest improvement expected over the least misfit that the emulators know
  double scatter = 0;         ///< misfit_scatter() where the misfit is least
  double emulator_share = 0;  ///< mean_emulator_share()

  /// Whether simulations can still change the answer: the gain exceeds the scatter over seeds, or the
  /// emulators add more than `kShareThatMatters` to the measurements' variance.
  bool worthwhile() const;
};

inline constexpr double kShareThatMatters = 0.25;

/// `taken`: places with runs, none of which is proposed again. Deterministic.
NextPoints next_points(const Likelihood& likelihood, const Region& region,
                       const std::vector<Eigen::VectorXd>& taken, std::size_t count, std::uint64_t seed);

}  // namespace diefill::process::calibration
