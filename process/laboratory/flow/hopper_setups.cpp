#include "process/laboratory/flow/hopper_setups.h"

#include <algorithm>
#include <cmath>

#include "process/laboratory/side_by_side.h"
#include "process/powder/empty_annulus.h"
#include "process/scene/powder/powder_presets.h"

namespace diefill::process::laboratory {

namespace {

constexpr double kFinest = 4.704e-4;  // m, d of the source's set-ups

}  // namespace

HopperSetup source_hopper(double factor) {
  HopperSetup setup;
  setup.powder = powder_preset("ASC100.29 initial D");
  setup.powder.friction = 0.5;
  setup.powder.grain_diameter = factor * kFinest;
  setup.depth = 2.16e-3;
  return setup;
}

void fit_to_grains(double factor, HopperSetup& setup) {
  setup.slit = setup.equivalent_slit + kEmptyAnnulus * (1 - 1 / factor) * setup.powder.grain_diameter;
  setup.depth *= setup.powder.grain_diameter / kFinest;
  setup.averaging_width = std::max(5e-4, 0.5 * setup.powder.grain_diameter);
}

double speed_scale(const HopperSetup& setup) {
  return std::sqrt(setup.gravity * setup.equivalent_slit);
}

std::vector<HopperFields> run_packings(const ExperimentOptions& options,
                                       const std::vector<HopperSetup>& setups, int packings) {
  std::vector<HopperSetup> runs;
  for (const HopperSetup& setup : setups)
    for (int seed = 1; seed <= packings; ++seed) {
      runs.push_back(setup);
      runs.back().seed = static_cast<std::uint64_t>(seed);
    }
  std::vector<HopperFields> found(runs.size());
  side_by_side(options, runs.size(), "hoppers", [&](std::size_t piece, const ShareCallback& on_progress) {
    found[piece] = run_hopper(runs[piece], on_progress);
  });
  std::vector<HopperFields> means;
  for (auto first = found.begin(); first != found.end(); first += packings)
    means.push_back(mean_of({first, first + packings}));
  return means;
}

}  // namespace diefill::process::laboratory
