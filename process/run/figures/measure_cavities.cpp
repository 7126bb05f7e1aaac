#include "process/run/figures/measure_cavities.h"

#include "process/measure/fields/measured_fields.h"
#include "process/measure/figures/counted_grains.h"
#include "process/measure/figures/enough_grains.h"
#include "process/measure/figures/figures.h"
#include "process/measure/figures/verdict.h"
#include "process/results/cavity_rows.h"
#include "process/results/no_value.h"
#include "process/run/assemble.h"
#include "process/run/figures/filling_figures.h"
#include "process/tooling/die_frame.h"
#include "process/tooling/examination/other_cavities.h"

namespace diefill::process {
namespace {

void measure_cavity(results::FillResult& result, const Scene& scene, const PowderBed& bed,
                    const std::vector<results::SectionPlane>& sections) {
  measure_fields(result, {scene.measure.averaging_width, sections}, scene.measure.azimuth_bins);
  add_filling_figures(result, scene, bed);
  measure_figures(result);
  withhold_poor_figures(result);
  if (result.cavity.volume > 0)
    results::add_statement(result, results::kVerdictTopic, results::verdict_name(1), verdict(result));
}

}  // namespace

void measure_cavities(results::FillResult& result, const Scene& scene, const Tooling& tooling,
                      const std::vector<results::SectionPlane>& sections) {
  std::vector<results::CavityState> all = {result.cavity};
  for (const auto& other : tooling.other_cavities) all.push_back(cavity_state(other));
  const PowderBed bed = powder_bed(result, all);
  add_powder_figures(result, scene, bed);
  const std::size_t deep = counted_grains(result.powder, result.solid_fraction, false).size();
  if (deep < kMinGrains)
    results::set_no_value(result, "bulk_solid_fraction",
                          too_few_text(deep, "two diameters below the surface", kMinGrains));
  measure_cavity(result, scene, bed, sections);
  add_other_cavities(result, tooling.other_cavities,
                     [&](results::FillResult& other) { measure_cavity(other, scene, bed, {}); });
}

}  // namespace diefill::process
