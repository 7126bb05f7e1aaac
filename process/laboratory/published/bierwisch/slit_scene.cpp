#include "process/laboratory/published/bierwisch/slit_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "process/continuum/discharge.h"
#include "process/powder/empty_annulus.h"
#include "process/results/figure_table.h"
#include "process/results/none.h"
#include "process/results/storage/result_file.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kUsual = 0.032, kWall = 0.003;  // m, of the shoe: inside and walls
constexpr double kAcceleration = 10;             // m/s^2
constexpr double kMargin = 1e-3;                 // m, between slit and shoe
constexpr double kPublishedStep = 2e-6;          // s, at the published grain size

/// m, where the shoe's middle starts.
double start_of(const SlitPassage& passage) {
  return 0.5 * passage.inside + kWall + 0.5 * passage.width + kMargin +
         passage.speed * passage.speed / (2 * kAcceleration);
}

/// The probe that counts what falls.
const results::ProbeSeries& slit_probe(const results::FillResult& result) {
  for (const auto& series : result.probes)
    if (series.name == "slit") return series;
  throw results::ResultError("the results have no probe \"slit\"");
}

/// kg that have fallen through by `time` (s).
double fallen(const results::ProbeSeries& probe, double time) {
  double mass = 0;
  for (std::size_t k = 0; k < probe.values.size(); k += probe.columns.size())
    if (probe.values[k] <= time) mass = probe.values[k + 1];
  return mass;
}

double slice_of(const results::FillResult& result) {
  return result.powder.period[1];
}

}  // namespace

double slice_depth(const LabPowder& powder, const SlitPassage& passage) {
  return passage.depth > 0 ? passage.depth : 4.6 * powder.size;
}

double time_over_slit(const SlitPassage& passage, double way) {
  return (start_of(passage) + way) / passage.speed + passage.speed / (2 * kAcceleration);
}

double adjusted_slit(double width, const LabPowder& powder) {
  return width + kEmptyAnnulus * (powder.size - powder.own_size);
}

SceneChanges slit_changes(const LabSetting& setting, const LabPowder& powder, const SlitPassage& passage) {
  const double start = start_of(passage), half = 0.5 * slice_depth(powder, passage);
  const double travel =
      passage.past ? 2 * start
                   : start + 0.5 * passage.inside + passage.speed * passage.speed / (2 * kAcceleration);
  SceneChanges changes = powder.changes;
  changes.set +=
      line("tool.\"right half of the platen\".position", point_in_millimetres(0.5 * passage.width, 0, 0));
  changes.set +=
      line("tool.\"left half of the platen\".position", point_in_millimetres(-0.5 * passage.width, 0, 0));
  changes.set += line("tool.shoe.position", point_in_millimetres(start, 0, 0));
  if (passage.inside != kUsual)
    changes.set +=
        line("tool.shoe.file", "\"../slit_plate/shoe_walls_" + plain(1e3 * passage.inside) + "mm.stl\"");
  changes.set += line("pour.from", point_in_millimetres(start - 0.5 * passage.inside, -half, 0));
  changes.set += line("pour.to", point_in_millimetres(start + 0.5 * passage.inside, half, 0.046));
  changes.set += line("pour.fill_height", millimetres(passage.fill));
  changes.set += line("step.passage.velocity", with_unit(passage.speed, "m/s"));
  changes.set += line("step.passage.travel", millimetres(travel));
  changes.set += line("numerics.periodic", "{ y = " + millimetres(2 * half) + " }");
  if (!has_own_powder(setting))
    changes.set +=
        line("numerics.time_step", with_unit(1e6 * kPublishedStep * powder.size / powder.own_size, "us"));
  return changes;
}

double discharged_area(const SeedResults& seed, const std::string& run) {
  const results::FillResult& result = seed.of(run);
  const double fraction = results::figure_of(seed.at(run, "settled"), "bulk_solid_fraction");
  const double mass = fallen(slit_probe(result), std::numeric_limits<double>::infinity());
  return mass / result.powder.grain_mass * result.powder.grain_solid_volume / (fraction * slice_of(result));
}

double published_grains(const SeedResults& seed, const std::string& run, const LabPowder& powder) {
  constexpr double kDepth = 2.16e-3;  // m
  const double fraction = results::figure_of(seed.at(run, "settled"), "bulk_solid_fraction");
  const double solid =
      seed.of(run).powder.grain_solid_volume * std::pow(powder.own_size / powder.size, 3);  // m^3, of a grain
  return discharged_area(seed, run) * fraction * kDepth / solid;
}

double steady_solid_rate(const SeedResults& seed, const std::string& run, const SlitPassage& passage) {
  constexpr double kLeftOut = 0.3;
  const results::FillResult& result = seed.of(run);
  const auto stage = std::find_if(result.stages.begin(), result.stages.end(),
                                  [](const auto& one) { return one.tool == "shoe"; });
  if (stage == result.stages.end()) return kNone;
  const double covered = 0.5 * passage.inside - 0.5 * passage.width;
  const double from = stage->start + time_over_slit(passage, -covered + kLeftOut * 2 * covered);
  const double to = stage->start + time_over_slit(passage, covered);
  const auto& probe = slit_probe(result);
  const double mass = fallen(probe, to) - fallen(probe, from);
  if (!(mass > 0)) return kNone;
  return mass / result.powder.grain_mass * result.powder.grain_solid_volume /
         (slice_of(result) * (to - from));
}

double measured_area(double width, double speed) {
  return continuum::mass_of_passage(continuum::kMeasuredDischarge, {1, width, 1, continuum::kStandardGravity},
                                    kUsual, speed);
}

}  // namespace diefill::process::laboratory
