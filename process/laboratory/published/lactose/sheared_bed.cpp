#include "process/laboratory/published/lactose/sheared_bed.h"

#include <cmath>

#include "engine/simulation/standard_gravity.h"
#include "process/laboratory/published/bed_window.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

using continuum::StressPoint;

constexpr const char *kHead = "head", *kPreshearedBed = "presheared";
constexpr double kStretch = 3;     // d at the rim, of the pre-shear's means
constexpr double kPeak = 0.3;      // d, over which the strength is a mean
constexpr double kTravel = 2;      // d, of the head after it is unloaded, up and down
constexpr double kSpringBack = 3;  // d at the rim, at most, until no torque acts on the head
constexpr double kRow = 0.02;      // d, between rows of the probe
constexpr double kSettle = 0.25;   // sqrt(d / g), until a new load is held
/// Of the head's motions: pressed, pre-sheared, freed of torque, unloaded, sheared.
constexpr std::size_t kPreshearMotion = 1, kShearMotion = 4, kMotions = 5;

std::string newtons(double force) {
  return with_unit(force, "N");
}

StressPoint strength_of(const SeedResults& seed, const ShearTest& test, double stress) {
  const auto spans = shear_spans(seed, test, stress);
  if (!spans) return {std::nan(""), std::nan("")};
  const MeanStress peak = highest_stress(head_curve(seed, test, stress), spans->shear.start, spans->shear.end,
                                         test.filled.seconds(kPeak));
  return {peak.normal, peak.shear};
}

}  // namespace

std::string ShearTest::run_name(double stress) const {
  return name + ", " + plain(1e-3 * stress) + " kPa";
}

std::vector<std::string> ShearTest::run_names() const {
  std::vector<std::string> names;
  for (const double stress : stresses) names.push_back(run_name(stress));
  return names;
}

LabRun run_of(const ShearTest& test, double stress) {
  const FilledCell& filled = test.filled;
  const double unit = std::sqrt(filled.powder.diameter() / engine::kStandardGravity);
  const std::string hold = with_unit(kSettle * unit, "s"), speed = turns_a_minute(filled.turn_speed());
  std::string set = filled_cell_lines(filled, kHead, "shear_head", filled.cell.vane_depth());
  const double d = filled.powder.diameter();
  set += line("step.press.force", newtons(filled.force(kPreshearStress)));
  set += line("step.preshear.start", "{ with = \"press\", force = " +
                                         newtons(0.98 * filled.force(kPreshearStress)) + ", on = \"head\" }");
  set += line("step.preshear.speed_limit", speed);
  set += line("step.preshear.steady", "{ over = " + degrees(filled.angle(kStretch)) + ", within = 0.03 }");
  set += line("step.preshear.angle", degrees(filled.angle(test.longest)));
  set += line("step.release.speed_limit", speed);
  set += line("step.release.back", degrees(filled.angle(kSpringBack)));
  set += line("step.release.pause", hold);
  set += line("step.unload.force", newtons(filled.force(stress)));
  set += line("step.unload.travel", millimetres(kTravel * d));
  set += line("step.unload.back", millimetres(kTravel * d));
  set += line("step.shear.start", "{ with = \"unload\", delay = " + hold + " }");
  set += line("step.shear.speed_limit", speed);
  set += line("step.shear.angle", degrees(filled.angle(test.sheared)));
  set += line("probe.head.interval", with_unit(filled.seconds(kRow), "s"));
  return {test.run_name(stress), "shear_tester.toml", {set, {}}};
}

std::vector<LabRun> runs_of(const std::vector<ShearTest>& tests) {
  std::vector<LabRun> runs;
  const std::size_t stresses = tests.empty() ? 0 : tests.front().stresses.size();
  for (std::size_t k = 0; k < stresses; ++k)
    for (const ShearTest& test : tests) runs.push_back(run_of(test, test.stresses[k]));
  return runs;
}

std::optional<ShearSpans> shear_spans(const SeedResults& seed, const ShearTest& test, double stress) {
  const auto spans = spans_of(seed, test.run_name(stress), kHead);
  if (spans.size() < kMotions) return std::nullopt;
  return ShearSpans{spans[kPreshearMotion], spans[kShearMotion]};
}

ShearCurve head_curve(const SeedResults& seed, const ShearTest& test, double stress) {
  return shear_curve(seed, test.run_name(stress), kHead, test.filled);
}

StressPoint preshear_of(const SeedResults& seed, const ShearTest& test) {
  const double stress = test.stresses.front();
  const auto spans = shear_spans(seed, test, stress);
  if (!spans) return {std::nan(""), std::nan("")};
  const double end = spans->preshear.end;
  const MeanStress steady =
      mean_stress(head_curve(seed, test, stress), end - 2 * test.filled.seconds(kStretch), end);
  return {steady.normal, steady.shear};
}

std::vector<StressPoint> strengths_of(const SeedResults& seed, const ShearTest& test) {
  std::vector<StressPoint> points;
  for (const double stress : test.stresses)
    if (seed.has(test.run_name(stress))) points.push_back(strength_of(seed, test, stress));
  return points;
}

continuum::YieldLocus locus_of(const SeedResults& seed, const ShearTest& test) {
  return continuum::yield_locus_through(strengths_of(seed, test));
}

double fraction_of(const SeedResults& seed, const ShearTest& test) {
  const auto& powder = seed.at(test.run_name(test.stresses.front()), kPreshearedBed).powder;
  const double d = test.filled.powder.diameter(), from = 2 * d,
               to = surface_of(powder) - (test.filled.cell.vane_depth() + 1) * d;
  return volume_between(powder, from, to) / (test.filled.area() * (to - from));
}

}  // namespace diefill::process::laboratory
