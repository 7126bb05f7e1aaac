// Discharge of the moving shoe against what the transient discharge of the hopper predicts (Bierwisch 2009,
// section 5.2.2, Eq. 5.17 with Table 5.2): model D, friction 0.5, no cohesion, a shoe of 32 mm. Coarse grains
// have wider slits as in shoe_discharge.cpp.
#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/experiments.h"

namespace diefill::process::laboratory {
namespace {

struct Point {
  const char* id;
  double width, speed;  ///< m, m/s
};

constexpr Point kPoints[] = {
    {"E06", 0.006, 0.2}, {"E07", 0.006, 0.4}, {"E08", 0.010, 0.2}, {"E09", 0.010, 0.4}};

std::string run_name(const Point& point) {
  return "slit " + plain(1e3 * point.width) + " mm, " + plain(point.speed) + " m/s";
}

}  // namespace

LabPlan plan_moving_shoe(const LabSetting& setting) {
  LabPowder powder = lab_powder(setting, "ASC100.29 initial D", setting.scale());
  if (!has_own_powder(setting))
    powder.changes.set += "powder.friction = 0.5\npowder.work_of_adhesion = \"0 J/m^2\"\n";
  LabPlan plan;
  for (const Point& point : kPoints) {
    const SlitPassage passage{.width = adjusted_slit(point.width, powder), .speed = point.speed};
    const std::string run = run_name(point);
    plan.runs.push_back({run, "slit.toml", slit_changes(setting, powder, passage)});
    plan.quantities.push_back(
        {.id = point.id, .quantity = "", .unit = "", .runs = {run}, .value = [run](const SeedResults& seed) {
           return 1e6 * discharged_area(seed, run);
         }});
  }
  return plan;
}

}  // namespace diefill::process::laboratory
