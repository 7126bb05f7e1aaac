// Slits passed by the shoe (sample_tools/laboratory/slit.toml): the scene for a width, speed and powder, and
// what runs through.
#pragma once

#include <string>
#include <vector>

#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {

/// One passage. SI units.
struct SlitPassage {
  double width = 0.01;    ///< m, D between the platen's edges
  double speed = 0.18;    ///< m/s
  double fill = 0.024;    ///< m, depth of the powder
  double depth = 0;       ///< m, b, the slice's period; 0: 4.6 d as published, but at least 4.1 d
  double inside = 0.032;  ///< m, of the shoe along its way, as there are drawings for: 32 or 45 mm
  bool past = true;       ///< the whole shoe passes; false: it stops with the slit under its trailing wall
};

/// Its scene with that powder.
SceneChanges slit_changes(const LabSetting& setting, const LabPowder& powder, const SlitPassage& passage);

/// m, the slice's depth that slit_changes takes.
double slice_depth(const LabPowder& powder, const SlitPassage& passage);

/// s after the step "passage" began, when the shoe's middle is `way` m beyond the slit's.
double time_over_slit(const SlitPassage& passage, double way);

/// m, width that lets grains of the model's size pass as wide a gap as the published ones: D + 1.4 (d' - d)
/// (Bierwisch 2009, section 3.2.2).
double adjusted_slit(double width, const LabPowder& powder);

/// m^2, discharged area: grains through the slit times their volume over solid fraction and slice depth
/// (Bierwisch 2009, Eq. 4.2); the fraction is that of the snapshot "settled".
double discharged_area(const SeedResults& seed, const std::string& run);

/// Grains of the published size through a slice of the published depth (2.16 mm) that fill the same area.
double published_grains(const SeedResults& seed, const std::string& run, const LabPowder& powder);

/// m^2/s, solid volume through the slit over time and slice depth while the whole slit lies under the powder,
/// the first 30 % of that time left out (Bierwisch 2009, section 3.2.2). NaN where nothing came through.
double steady_solid_rate(const SeedResults& seed, const std::string& run, const SlitPassage& passage);

/// m^2, discharge of the measured powder (Bierwisch 2009, Eq. 4.1 with Table 4.1).
double measured_area(double width, double speed);

}  // namespace diefill::process::laboratory
