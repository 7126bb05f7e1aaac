// What a longer step does to a result: solid fraction of a settled bed of clumps.
#include <cmath>

#include "engine/numerics/out_of_range.h"
#include "process/input/scene_error.h"
#include "process/laboratory/settled_bed.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

/// The default powder (Bierwisch 2009, Table C.4: model D, mu = 0.25), four times as large.
BedSpec bed_with(double time_step, bool quick, std::uint64_t seed) {
  BedSpec spec;
  spec.powder.grain_diameter *= 4;
  spec.width = spec.depth = (quick ? 4.5 : 8) * spec.powder.grain_diameter;
  spec.fill_height = quick ? 12e-3 : 24e-3;
  spec.wall_sphere_radius = 3e-4;
  spec.time_step = time_step;
  spec.seed = seed;
  return spec;
}

}  // namespace

void find_effect_of_step(const ExperimentOptions& options, results::ExperimentResult& result) {
  constexpr double kPublished =
      4 * 2e-6;  // s, 2 us at d = 0.47 mm (Bierwisch 2009, Table C.4), in proportion to d
  results::ExperimentChart chart;
  chart.name = "step_effect";
  chart.title = "Solid fraction of a settled bed over the time step";
  chart.subtitle = "Model D, d = 1.88 mm; 1: the published step of 2 us at d = 0.47 mm in proportion to d";
  chart.note = "No point: refused in advance or stopped by the validity check.";
  chart.x = {.label = "Time step over the published one", .logarithmic = true};
  chart.y = {.label = "Solid fraction", .lower = 0.37, .upper = 0.41};
  for (std::uint64_t seed = 1; seed <= (options.quick ? 2U : 3U); ++seed) {
    results::ExperimentSeries curve{.name = "seed " + std::to_string(seed), .x = {}, .y = {}};
    for (const double factor : {1.0, 2.0, 3.0, 4.0, 6.0}) {
      BedSpec spec = bed_with(factor * kPublished, options.quick, seed);
      spec.threads = options.threads;
      double fraction = std::nan("");
      try {
        fraction = settle_bed(spec).bulk_fraction;
      } catch (const engine::OutOfRange&) {
        // Stopped by the validity check: a result, not an error.
      } catch (const SceneError&) {
        // Refused in advance: above the critical step, or that of lasting contacts.
      }
      curve.x.push_back(factor);
      curve.y.push_back(fraction);
      result.limits.push_back({"solid fraction with " + std::to_string(static_cast<int>(factor)) +
                                   " times the published step, seed " + std::to_string(seed),
                               fraction, std::nan(""), "1", ""});
    }
    chart.series.push_back(curve);
  }
  result.charts = {chart};
}

}  // namespace diefill::process::laboratory
