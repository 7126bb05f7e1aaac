// Does fine lactose arch in a wedge hopper (Kottlan 2018, section 3.4)? A periodic slice between two walls at
// the half angle of Jenike's design, filled over a gate that falls away; the same with the slot twice as
// wide, and without attraction. The slots are some grain diameters wide: that of the design is thousands, so
// that arching is expected and the comparison is qualitative. Coarse: slots of 8 and 16 d, a slice of 4 d, 3
// times of free fall through the slot's width; medium: 12 and 24 d, 6 d, 5 times; published: 20 and 40 d, 10
// d, 10 times.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/simulation/standard_gravity.h"
#include "process/laboratory/published/dosta/bulk_curves.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/lactose/adhesive_bed.h"
#include "process/laboratory/published/lactose/hopper_design.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kGravity = engine::kStandardGravity;
constexpr double kDepth = 1.2;                   // over the slot's width, of loose powder in the hopper
constexpr double kLattice = 1.12, kLoose = 0.5;  // d; solid fraction that `fill_height` is computed with
constexpr double kSolid = 0.3;                   // of the powder over the gate, about
constexpr double kFall = 2;  // over the time of falling from the lattice's middle to the slot

struct Hopper {
  std::string name;  ///< of the run
  double slot;       ///< d
  double slice;      ///< d
  double times;      ///< of free fall through the slot's width
  Packing packing = Packing::clusters;

  double free_fall() const { return std::sqrt(2 * slot * lh220().diameter() / kGravity); }  ///< s
};

std::vector<Hopper> hoppers(LabSize size) {
  Hopper narrow{"slot", 8, 4, 3}, wide{"double slot", 16, 4, 3};
  if (size == LabSize::medium) narrow = {"slot", 12, 6, 5}, wide = {"double slot", 24, 6, 5};
  if (size == LabSize::published) narrow = {"slot", 20, 10, 10}, wide = {"double slot", 40, 10, 10};
  Hopper free = wide;
  free.name = "double slot, no attraction", free.packing = Packing::free;
  return {narrow, wide, free};
}

std::string rotation(double degrees) {
  return "{ axis = \"y\", angle = " + with_unit(degrees, "deg") + " }";
}

std::string tool_lines(const Hopper& hopper, double half_angle) {
  constexpr double kWall = 6, kDrawnWall = 100, kDrawnGate = 20, kAway = 10;  // slots; as drawn; slots
  const double slot = hopper.slot * lh220().diameter(), edge = 0.5 * slot;
  std::string set = line("tool.right.rotation", rotation(half_angle - 90));
  set += line("tool.right.position", point_in_millimetres(edge, 0, 0));
  set += line("tool.left.rotation", rotation(90 - half_angle));
  set += line("tool.left.position", point_in_millimetres(-edge, 0, 0));
  for (const char* wall : {"right", "left"})
    set += line(std::string("tool.") + wall + ".length_unit", with_unit(kWall * slot / kDrawnWall, "m"));
  set += line("tool.gate.length_unit", with_unit(slot / kDrawnGate, "m"));
  set += line("step.open.distance", millimetres(kAway * slot));
  return set;
}

LabRun wedge_hopper_run(const Hopper& hopper) {
  const double d = lh220().diameter(), half_angle = published_hopper().half_angle;
  const double widening = std::tan(half_angle * std::numbers::pi / 180);
  const double depth = kDepth * hopper.slot, top = hopper.slot + 2 * depth * widening;  // d
  // Spheres of the wedge between slot and depth, poured over the width that it has there.
  const double grains = 0.5 * (hopper.slot + top) * depth * hopper.slice * kSolid * 6 / std::numbers::pi;
  const double fill = grains * std::numbers::pi / 6 / (top * hopper.slice * kLoose);
  const double lattice =
      (std::ceil(grains / (0.5 * top * hopper.slice / (kLattice * kLattice))) + 2) * kLattice;
  std::string set = powder_lines(lh220(), hopper.packing) + fine_wall_lines(lh220(), hopper.slot * d) +
                    tool_lines(hopper, half_angle);
  // From where the wedge is as wide as the box: below it, its corners lie outside the walls.
  set += line("pour.from", point_in_millimetres(-0.5 * top * d, -0.5 * hopper.slice * d, depth * d));
  set += line("pour.to", point_in_millimetres(0.5 * top * d, 0.5 * hopper.slice * d, (depth + lattice) * d));
  set += line("pour.fill_height", millimetres(fill * d));
  set += line("numerics.periodic", "{ y = " + millimetres(hopper.slice * d) + " }");
  set += line("step.fall.duration", with_unit(kFall * std::sqrt((2 * depth + lattice) * d / kGravity), "s"));
  set += line("step.flow.duration", with_unit(hopper.times * hopper.free_fall(), "s"));
  set += line("probe.slot.origin", point_in_millimetres(0, 0, -d));
  set += line("probe.slot.interval", with_unit(0.01 * hopper.times * hopper.free_fall(), "s"));
  set += line("measure.averaging_width", millimetres(d));
  return {hopper.name, "wedge_hopper.toml", {set, {}}};
}

/// Percent of the powder beyond the slot, over the time since the gate left in times of free fall.
TimeCurve discharged(const SeedResults& seed, const Hopper& hopper) {
  TimeCurve curve = probe_curve(seed, hopper.name, "slot", "mass");
  const auto& filled = seed.at(hopper.name, "filled").powder;
  const double start = start_of_motion(seed, hopper.name, "gate");
  const double all = static_cast<double>(filled.position.size()) * filled.grain_mass;
  for (double& time : curve.time) time = (time - start) / hopper.free_fall();
  for (double& value : curve.value) value *= 100 / all;
  return curve;
}

double discharged_at_the_end(const SeedResults& seed, const Hopper& hopper) {
  return discharged(seed, hopper).value.back();
}

results::ExperimentChart wedge_hopper_chart(const std::vector<Hopper>& all, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "wedge_hopper";
  chart.title = "Discharge of fine lactose through a slot";
  chart.subtitle = "Wedge hopper, half angle of " +
                   plain(std::round(10 * published_hopper().half_angle) / 10) + " deg, slots of " +
                   plain(all[0].slot) + " and " + plain(all[1].slot) + " d (Kottlan 2018)";
  chart.x = {.label = "Time since opening over free-fall time through the slot's width [1]", .lower = 0};
  chart.y = {.label = "Discharged share of the powder [%]", .lower = 0, .upper = 105};
  for (const Hopper& hopper : all) {
    if (!seed.has(hopper.name)) continue;
    const TimeCurve curve = discharged(seed, hopper);
    results::ExperimentSeries series{
        .name = hopper.name, .role = results::ExperimentSeries::Role::predicted, .x = {}, .y = {}};
    for (std::size_t k = 0; k < curve.time.size(); ++k) {
      if (curve.time[k] < 0 || curve.time[k] > hopper.times) continue;
      series.x.push_back(curve.time[k]);
      series.y.push_back(curve.value[k]);
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace

LabPlan plan_wedge_hopper(const LabSetting& setting) {
  const std::vector<Hopper> all = hoppers(setting.size);
  LabPlan plan;
  for (const Hopper& hopper : all) {
    plan.runs.push_back(wedge_hopper_run(hopper));
    plan.quantities.push_back(
        {.id = hopper.name,
         .quantity = "discharged, " + hopper.name,
         .unit = "%",
         .runs = {hopper.name},
         .value = [=](const SeedResults& seed) { return discharged_at_the_end(seed, hopper); }});
  }
  const Hopper &narrow = all[0], &wide = all[1];
  plan.quantities.push_back({.id = "HOP-1",
                             .quantity = "",
                             .unit = "",
                             .runs = {narrow.name, wide.name},
                             .value = [=](const SeedResults& seed) {
                               return std::max(discharged_at_the_end(seed, narrow),
                                               discharged_at_the_end(seed, wide));
                             }});
  plan.charts = [all](const SeedResults& seed) { return std::vector{wedge_hopper_chart(all, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
