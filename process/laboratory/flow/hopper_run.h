// A flat-bottomed hopper that empties through a slit, periodic along y: fields of velocity and solid fraction
// while it flows (Bierwisch 2009, section 5.1).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/simulation/standard_gravity.h"
#include "process/continuum/kinematic_model.h"
#include "process/results/fill_result.h"
#include "process/scene/scene.h"

namespace diefill::process::laboratory {

/// One set-up. SI units.
struct HopperSetup {
  std::string name;
  PowderSpec powder;               ///< at its wanted grain size
  double slit = 15e-3;             ///< m, between the floor's spheres
  double equivalent_slit = 15e-3;  ///< m, D: the source's slit, as wide for its grains as `slit` for these
  double width = 45e-3;            ///< m, l, between the side walls
  double depth = 8.64e-3;          ///< m, b, the period along y
  double gravity = engine::kStandardGravity;  ///< m/s^2
  double fill = 75e-3;                        ///< m, level before the slit opens
  double from = 65e-3, to = 50e-3;            ///< m, levels between which fields are taken
  double averaging_width = 0.94e-3;           ///< m, sigma of Eq. 2.27
  std::uint64_t seed = 1;
  int threads = 1;
};

/// Means over time, of the grains alone (Eq. 2.27 with v or the solid fraction of their cells), on the
/// columns and levels of the grid; NaN where there was no grain. Symmetrical about x = 0: both halves count.
struct HopperFields {
  continuum::HopperGrid grid;
  std::vector<double> vertical, horizontal;  ///< m/s, (rows + 1) x columns
  std::vector<double> fraction;              ///< the same size
  /// m^2/s of bulk powder while fields were taken, over the period; NaN where none were taken.
  double outflow = 0;
  double bulk_fraction = 0;    ///< of the settled powder
  double flowing_seconds = 0;  ///< s, that fields were taken for; NaN likewise
  std::size_t samples = 0, grains = 0;
  /// s since the opening, and m^2 of bulk powder over the period that has passed z = 0 by then, by the volume
  /// of the spheres' parts below it.
  std::vector<double> time, discharged;

  double at(const std::vector<double>& field, int column, int row) const {
    return field[static_cast<std::size_t>(row) * grid.columns + column];
  }
};

/// How many grains' worth of spheres lies below z = 0, with the parts of spheres that reach below it.
double grains_below_slit(const results::PowderState& powder);

/// Settles the powder above the closed slit, opens it at once, and takes fields every 0.5 ms (solid fractions
/// every 4 ms) between the two levels, not before 0.1 s sqrt(9.81 m/s^2 / g). `on_progress` receives the
/// finished share.
HopperFields run_hopper(const HopperSetup& setup, const std::function<void(double)>& on_progress);

/// The mean of several packings of one set-up; of the outflow, of those that have one.
HopperFields mean_of(const std::vector<HopperFields>& packings);

}  // namespace diefill::process::laboratory
