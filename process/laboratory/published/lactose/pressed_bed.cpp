#include "process/laboratory/published/lactose/pressed_bed.h"

#include "process/laboratory/published/bed_window.h"
#include "process/laboratory/published/dosta/bulk_curves.h"

namespace diefill::process::laboratory {
namespace {

constexpr LoadCycle kLoads;
constexpr double kTouch = 50;  // Pa
constexpr const char *kPlate = "plate", *kPacked = "packed", *kPressed = "pressed";

}  // namespace

double PressedBed::area() const {
  const double width = bed.width * powder.diameter();
  return width * width;
}

AdhesiveBed pressed_bed_of(LabSize size) {
  if (size == LabSize::coarse) return {6, 10};
  if (size == LabSize::medium) return {8, 15};
  return {16, 20};
}

LabRun run_of(const PressedBed& bed) {
  Loads loads;
  loads.stresses = {kLoads.high};
  for (int k = 0; k < kLoads.cycles; ++k)
    loads.stresses.insert(loads.stresses.end(), {kLoads.low, kLoads.high});
  loads.stresses.push_back(kLoads.low);
  return {bed.name, "adhesive_bed.toml", {pressed_bed_lines(bed.powder, bed.bed, loads), {}}};
}

LoadCurve load_curve(const SeedResults& seed, const PressedBed& bed) {
  const double start = plate_height(bed.bed) * bed.powder.diameter();
  const TimeCurve force = probe_curve(seed, bed.name, kPlate, "force z"),
                  shift = probe_curve(seed, bed.name, kPlate, "shift z");
  const double lowered = start_of_motion(seed, bed.name, kPlate);
  LoadCurve curve;
  for (std::size_t k = 0; k < force.value.size(); ++k) {
    const double stress = force.value[k] / bed.area();
    // Flying spheres hit the plate, too, before it moves.
    if (force.time[k] < lowered || (curve.stress.empty() && stress < kTouch)) continue;
    curve.height.push_back(start + shift.value[k]);
    curve.stress.push_back(stress);
  }
  return curve;
}

PullCurve pull_curve(const SeedResults& seed, const PressedBed& bed) {
  const TimeCurve force = probe_curve(seed, bed.name, kPlate, "force z"),
                  shift = probe_curve(seed, bed.name, kPlate, "shift z");
  double from = 0, to = 0;  // of the plate's last motion
  for (const auto& stage : seed.of(bed.name).stages)
    if (stage.tool == kPlate) from = stage.start, to = stage.end;
  PullCurve curve;
  for (std::size_t k = 0; k < force.time.size(); ++k) {
    if (force.time[k] < from || force.time[k] > to) continue;
    curve.travel.push_back(shift.value[k]);
    curve.pull.push_back(-force.value[k]);
  }
  return curve;
}

const results::PowderState& packed_bed(const SeedResults& seed, const std::string& run) {
  return seed.at(run, kPacked).powder;
}

BedMetrics metrics_of(const SeedResults& seed, const PressedBed& bed) {
  const Tension tension = tension_of(pull_curve(seed, bed));
  return {middle_fraction(packed_bed(seed, bed.name)), middle_fraction(seed.at(bed.name, kPressed).powder),
          stiffness_of(load_curve(seed, bed), kLoads), tension.strength / bed.area(),
          tension.fracture / bed.powder.diameter()};
}

double middle_fraction(const results::PowderState& powder) {
  const double top = surface_of(powder);
  return fraction_between(powder, 0.2 * top, 0.8 * top);
}

}  // namespace diefill::process::laboratory
