#include "process/laboratory/published/bierwisch/wall_shear.h"

#include <algorithm>
#include <cmath>

#include "process/laboratory/published/dosta/bulk_curves.h"
#include "process/results/none.h"

namespace diefill::process::laboratory {
namespace {

// m, of the scene, which holds grains of kGrain
constexpr double kGrain = 0.95e-3, kPeriod = 4.8e-3, kFill = 5e-3, kPourTop = 25e-3, kLid = 30e-3;
constexpr double kLowest = 4.6e-3, kWay = 0.040;  // m, of the lid above the plate; of the plate
constexpr double kWallRadius = 1.5e-4;            // m, R_w at the published grain size
constexpr double kLeftOut = 0.25;                 // of the way, before forces are looked at

double enlarged(double length, const LabPowder& powder) {
  return length * std::max(1.0, powder.size / kGrain);
}

double area_of(const LabPowder& powder) {
  const double period = enlarged(kPeriod, powder);
  return period * period;
}

}  // namespace

double imposed_load(const LabPowder& powder, const WallShear& shear) {
  return shear.stress * area_of(powder);
}

SceneChanges wall_shear_changes(const LabSetting& setting, const LabPowder& powder, const WallShear& shear) {
  const double period = enlarged(kPeriod, powder), half = 0.5 * period, lid = enlarged(kLid, powder);
  SceneChanges changes = powder.changes;
  std::string& set = changes.set;
  set += line("tool.plate.sphere_radius", millimetres(kWallRadius * powder.size / powder.own_size));
  set += line("tool.lid.position", point_in_millimetres(0, 0, lid));
  set += line("pour.from", point_in_millimetres(-half, -half, 0));
  set += line("pour.to", point_in_millimetres(half, half, enlarged(kPourTop, powder)));
  set += line("pour.fill_height", millimetres(enlarged(kFill, powder)));
  set += line("step.press.force", with_unit(imposed_load(powder, shear), "N"));
  set += line("step.press.travel", millimetres(lid - enlarged(kLowest, powder)));
  set += line("step.shear.velocity", with_unit(shear.speed, "m/s"));
  set += line("step.shear.distance", millimetres(enlarged(kWay, powder)));
  set += line("numerics.periodic", "{ x = " + millimetres(period) + ", y = " + millimetres(period) + " }");
  if (!has_own_powder(setting))
    set += line("numerics.time_step", with_unit(2 * powder.size / powder.own_size, "us"));
  return changes;
}

WallForces wall_forces(const SeedResults& seed, const std::string& run, const LabPowder& powder,
                       const WallShear& shear) {
  const TimeCurve along = probe_curve(seed, run, "plate", "force x"),
                  across = probe_curve(seed, run, "plate", "force z");
  const double start = start_of_motion(seed, run, "plate"), way = enlarged(kWay, powder);
  WallForces sum{0, 0};
  double count = 0;
  for (std::size_t k = 0; k < along.time.size(); ++k) {
    const double gone = shear.speed * (along.time[k] - start);
    if (gone < kLeftOut * way || gone > 0.98 * way) continue;
    sum.along += std::abs(along.value[k]);
    sum.across += std::abs(across.value[k]);
    ++count;
  }
  return count > 0 ? WallForces{sum.along / count, sum.across / count} : WallForces{kNone, kNone};
}

double effective_friction(const SeedResults& seed, const std::string& run, const LabPowder& powder,
                          const WallShear& shear) {
  const WallForces forces = wall_forces(seed, run, powder, shear);
  return forces.across > 0 ? forces.along / forces.across : kNone;
}

}  // namespace diefill::process::laboratory
