// Beds of cohesive spheres that come in above a plane floor and settle (Hu 2024, sections 5.2, 6.2 and 6.3):
// keys of sticky_bed.toml, and what is read off a bed.
#pragma once

#include <string>

#include "process/laboratory/published/hu/cohesive_spheres.h"
#include "process/laboratory/published/scene_experiment.h"

namespace diefill::process::laboratory {

/// Where and when spheres come in. SI units.
struct Insertion {
  double width = 0.021, region = 0.020;  ///< m, of the period, and of the region that spheres come in at
  double from = 0.240, to = 0.330;       ///< m above the floor
  double mass = 16.8e-3;                 ///< kg on width squared
  double time = 10;                      ///< s; 0: all at once
  double rest = 2;                       ///< s, of settling afterwards
};

/// The same bed of another width (m), with as much powder on each square metre.
Insertion of_width(Insertion insertion, double width);

struct InsertedBed {
  std::string name;  ///< of the run
  CohesiveSpheres spheres;
  Insertion insertion;
};

LabRun run_of(const InsertedBed& bed);

/// What is measured between two heights.
struct InsertedBedFigures {
  double density = 0;   ///< kg/m^3
  double contacts = 0;  ///< of a sphere
  double height = 0;    ///< m, of the whole bed
  double kinetic = 0;   ///< mean kinetic energy of a sphere over m g d
};

InsertedBedFigures figures_of(const SeedResults& seed, const std::string& run, double from, double to);

/// A row for a figure of one bed without a published value.
LabQuantity own_figure(const std::string& run, const std::string& what, const std::string& unit, double from,
                       double to, double InsertedBedFigures::*figure);

/// %, by which `value` differs from `reference`, without its sign.
double percent_apart(double value, double reference);

}  // namespace diefill::process::laboratory
