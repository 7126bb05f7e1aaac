// The grain models of Bierwisch 2009: a row for each holds all that differs between them. To add one: its row
// in grain_models.cpp and its letter in GrainModel.
#pragma once

#include <span>

#include "process/scene/powder/powder_spec.h"

namespace diefill::process {

/// What a grain model is.
struct GrainModelFacts {
  GrainModel model;
  const char* name;       ///< as scenes spell it
  const char* words;      ///< for people
  bool single_sphere;     ///< a clump otherwise
  bool rotates;           ///< whether grains have orientation and spin
  bool rolling_friction;  ///< whether `powder.rolling_friction` acts on them
  double sphere_radius;   ///< m, basic radius R at the reference size; all have the same solid volume there
  double grain_diameter;  ///< m, the reference size as printed: 0.47 mm for D, where 6 R is 0.4704 mm
  double over_radius;     ///< d / R
  double settled[2][2];   ///< expected solid fraction at rest, by [cohesive][friction of 0.5 or more]
  engine::GrainShape (*shape)(double sphere_radius, double mass);  ///< m, kg
};

/// In the order of the letters.
std::span<const GrainModelFacts> grain_models();

/// Throws std::logic_error for GrainModel::clump, of which each powder has its own.
const GrainModelFacts& facts_of(GrainModel model);

/// "D"; "clump" for one of the powder's own.
const char* name_of(GrainModel model);

/// Whether the powder's grains are single spheres; whether they rotate; whether rolling friction acts on
/// them.
bool has_single_spheres(const PowderSpec& powder);
bool rotates(const PowderSpec& powder);
bool has_rolling_friction(const PowderSpec& powder);

/// Whether grains that fall straight onto others stay there, so that powder from a narrow lattice settles in
/// vertical columns: spheres that stick and do not rotate.
bool stacks_in_columns(const PowderSpec& powder);

}  // namespace diefill::process
