// The wedge hopper that Jenike's procedure gives for the published shear test of the powder of the hopper
// (Kottlan 2018, section 3.4, Table 15, predicted): pre-shear above the yield locus, wall angle measured.
#include "process/laboratory/published/lactose/hopper_design.h"

#include "process/laboratory/published/experiments.h"

namespace diefill::process::laboratory {

continuum::WedgeHopper published_hopper() {
  return continuum::wedge_hopper({.preshear_normal = 3e3,
                                  .preshear = 2.39e3,
                                  .slope = 0.457,
                                  .cohesion = 0.763e3,
                                  .wall_angle = 20.03,
                                  .bulk_density = 0.38 * 1545});
}

LabPlan plan_hopper_design(const LabSetting&) {
  const continuum::WedgeHopper hopper = published_hopper();
  LabPlan plan;
  const auto add = [&](const char* id, double value) {
    plan.quantities.push_back(
        {.id = id, .quantity = "", .unit = "", .runs = {}, .value = [value](const SeedResults&) {
           return value;
         }});
  };
  add("HOP-design-half", hopper.half_angle);
  add("HOP-design-minimum", hopper.slot_width);
  return plan;
}

}  // namespace diefill::process::laboratory
