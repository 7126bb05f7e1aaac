#include "process/estimate/statements/known_error.h"

#include "process/scene/powder/unchanged_preset.h"

namespace diefill::process::estimate {

namespace {

/// Nine of ten runs of this powder are no further off (against_runs.csv, README.md).
constexpr double kOfDistaloy = 1.5, kPacking = 0.05;

}  // namespace

KnownError known_error(const Scene& scene, bool own_law) {
  const bool one_powder = scene.other_powders.empty() && scene.powder.sizes.empty();
  if (one_powder && !own_law && powder_as_published(scene).name == "Distaloy AE")
    return {true, kOfDistaloy, kPacking, "process/estimate/against_runs.csv"};
  return {false, 2, 0, "not measured for this powder"};
}

}  // namespace diefill::process::estimate
