#include "process/laboratory/published/experiments.h"

namespace diefill::process::laboratory {

const std::vector<SceneExperiment>& scene_experiments() {
  static const std::vector<SceneExperiment> all = {
      {"closed_forms", "do laws, grains, turning and formulas give exact results?", plan_closed_forms},
      {"clump_collision", "are collisions the same for all grain sizes, and only with all parameters scaled?",
       plan_clump_collision},
      {"bulk_formation",
       "are overlaps, contacts and solid fraction of fallen beds the same for all grain sizes?",
       plan_bulk_formation},
      {"slit_flow", "does steady discharge of all grain sizes depend on the slit width less 1.4 d?",
       plan_slit_flow},
      {"shoe_discharge", "does discharge from the moving shoe follow the measured curve over its speed?",
       plan_shoe_discharge},
      {"slit_fields", "how do grains move near the slit while the shoe passes?", plan_slit_fields},
      {"moving_shoe", "does flow out of a hopper predict the discharge of the moving shoe?",
       plan_moving_shoe},
      {"angle_of_repose", "which angles do heaps on slider and floor have?", plan_angle_of_repose},
      {"mean_fractions", "which solid fraction has powder in the shoe, at rest and in motion?",
       plan_mean_fractions},
      {"fill_height", "does discharge depend on the depth of powder in the shoe?", plan_fill_height},
      {"packing_scatter", "how much does discharge scatter over packings of the same powder?",
       plan_packing_scatter},
      {"youngs_modulus", "does Young's modulus change solid fraction and discharge?", plan_youngs_modulus},
      {"damping", "does damping change solid fraction and discharge?", plan_damping},
      {"uniaxial_compression", "does a pressed bed of enlarged spheres resist like the original?",
       plan_uniaxial_compression},
      {"impact", "how deep does a steel ball fall into a bed, beside other codes?", plan_ball_impact},
      {"silo", "how fast does a silo discharge through two openings, beside other codes?", plan_silo},
      {"drum", "how do grains of two materials spread in a rotating drum?", plan_drum},
      {"packing", "how dense do adhesive spheres pack, by diameter and way of packing?", plan_packing},
      {"confined_compression", "how far and how stiffly do adhesive beds give in cycles of load?",
       plan_confined_compression},
      {"shear_tester", "which yield locus, strength and flow function have adhesive beds under a vaned head?",
       plan_shear_tester},
      {"wall_friction", "which angle of friction has powder on a turning disc?", plan_wall_friction},
      {"wedge_hopper", "does adhesive powder arch over the slot of a wedge hopper?", plan_wedge_hopper},
      {"lactose_screening", "which of twelve parameters change packing, compression and tension of beds?",
       plan_lactose_screening},
      {"lactose_large_range", "do main and pair effects describe beds over a wide range of parameters?",
       plan_lactose_large_range},
      {"lh100_range", "how far do beds differ over the range of LH100, and do effects describe them?",
       plan_lh100_range},
      {"lh220_range", "how far do beds differ over the range of LH220, and do effects describe them?",
       plan_lh220_range},
      {"hopper_design", "which hopper does Jenike's procedure give for a published shear test?",
       plan_hopper_design},
      {"powder_sheet", "which density, flow and angles has a powder in the tests of powder metallurgists?",
       plan_powder_sheet},
  };
  return all;
}

}  // namespace diefill::process::laboratory
