// powder.spheres: a clump of the user's own, in the scene or in a file of its own.
#pragma once

#include "process/input/table_reader.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Reads `spheres` or `spheres_file` of [powder] into the powder: model "clump", whose size is the distance
/// of two opposite points of the sphere about its centre of mass that holds it. `density`: kg/m^3 of the
/// grain; 0: from powder.grain_mass. Does nothing where neither key is given.
void read_clump(TableReader& table, PowderSpec& powder, double density);

}  // namespace diefill::process
