// Beds of powder that fall and settle in a box periodic in x and y: bulk formation (Bierwisch 2009,
// section 3.2.1, Figs. 3.2 to 3.4) and mean solid fractions (section 4.1.5, Table 4.4).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "process/results/fill_result.h"
#include "process/scene/scene.h"

namespace diefill::process::laboratory {

/// A bed to be settled. SI units.
struct BedSpec {
  PowderSpec powder;                ///< at its wanted grain size
  bool side_walls = false;          ///< walls across x at +- width / 2 instead of a period
  double width = 0, depth = 0;      ///< m, periodic lengths along x and y
  double fill_height = 0;           ///< m, of the settled bed, roughly
  double expected_fraction = 0.35;  ///< sets the number of grains
  double lattice_fraction = 0.1;    ///< solid fraction of the lattice that the grains fall from
  double lattice_constant = 0;      ///< of that lattice, over d; 0: from lattice_fraction
  double wall_sphere_radius = 0;    ///< m, of the ground
  double ground_spacing = 1.6;      ///< over that radius
  bool mesh_ground = false;         ///< ground of triangles; measured as if of spheres
  bool ground_at_surface =
      true;  ///< tops of the ground spheres at z = 0; otherwise their centres (Table C.2)
  std::optional<double> time_step;  ///< s; otherwise from the fraction
  double time_step_fraction = 0;    ///< of the critical step; 0: the default
  LeverArm lever_arm = LeverArm::contact;
  TangentialSpring spring = TangentialSpring::cut_back;
  std::uint64_t seed = 1;
  int threads = 2;
};

/// What a settled bed is like.
struct BedFigures {
  double bulk_fraction = 0;        ///< sum of solid over sum of cell volumes, top 2 d left out (OP-11)
  double arithmetic_fraction = 0;  ///< plain mean over the same grains
  double coordination =
      0;  ///< mean number of distinct grains that touch a grain, top and bottom 2 d left out
  double coordination_of_all = 0;          ///< the same over all grains
  double overlap_peak = 0;                 ///< h / d where the histogram of contacts has its peak
  double mean_overlap = 0;                 ///< mean h / d
  double lowest_fraction_near_ground = 0;  ///< of the profile up to 2 d, its final drop to 0 left out
  double bulk_reached_at =
      0;  ///< z / d from which on the profile stays within 10 % of the bulk fraction (up to 2 d)
  std::size_t grains = 0, contacts = 0;
  double simulated = 0;  ///< s
  std::uint64_t sphere_steps = 0;
  double energy_balance_error = 0;
  std::vector<double> height, fraction;    ///< z / d and share of the plane at z that is solid, every d / 20
  std::vector<double> overlap, frequency;  ///< h / d (middle of the bin) and share of contacts
};

/// Lets a bed fall and settle, then measures it.
BedFigures settle_bed(const BedSpec& spec);

}  // namespace diefill::process::laboratory
