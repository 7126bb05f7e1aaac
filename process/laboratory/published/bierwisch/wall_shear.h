// Powder held back by a lid with a blade on a moving plate of wall spheres
// (sample_tools/laboratory/wall_friction.toml): the scene for a powder, load and speed, and the forces on the
// plate.
#pragma once

#include <string>

#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {

struct WallShear {
  double stress = 1000;  ///< Pa, under the lid
  double speed = 0.5;    ///< m/s, of the plate
};

/// The scene with that powder. Wall spheres of the plate are enlarged with the grains; all lengths are, where
/// grains are larger than 0.94 mm.
SceneChanges wall_shear_changes(const LabSetting& setting, const LabPowder& powder, const WallShear& shear);

/// N, of the lid's load.
double imposed_load(const LabPowder& powder, const WallShear& shear);

/// Mean forces (N) on the plate after the first quarter of its way; NaN without any.
struct WallForces {
  double along, across;
};
WallForces wall_forces(const SeedResults& seed, const std::string& run, const LabPowder& powder,
                       const WallShear& shear);

/// Force along the plate over force across it, powder included (Bierwisch 2009, section 4.2.4); NaN without
/// load.
double effective_friction(const SeedResults& seed, const std::string& run, const LabPowder& powder,
                          const WallShear& shear);

}  // namespace diefill::process::laboratory
