// Runs of a scene with powders drawn from the region that a calibration has found: what the uncertainty of
// the powder does to a filled die.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/compare/collect.h"
#include "process/results/studies/powder_spread.h"
#include "process/scene/variants.h"

namespace diefill::process::calibration {

/// The account of a calibrated powder's file.
struct PowderRegion {
  std::filesystem::path file;
  std::vector<std::string> keys, units;
  std::vector<double> best;
  std::vector<std::vector<double>> samples;  ///< powders that agree with the data
};

/// That of `powder.file` of a scene. Throws SceneError where the scene has none, or where the file has no
/// samples.
PowderRegion powder_region_of(const std::filesystem::path& scene_file);

/// Throws SceneError where `scene` has a value of its own of a fitted key, with its line: the best powder's
/// runs would have that value, and those of the samples another one. The scene is as it is to be run, changes
/// included.
void refuse_own_values(const Scene& scene, const PowderRegion& region);

/// `count` samples spread over all of them: the same for the same seed. Throws SceneError for more than there
/// are.
std::vector<std::vector<double>> drawn_samples(const PowderRegion& region, int count, std::uint64_t seed);

/// The runs: the best powder with `seeds` consecutive seeds from the scene's own, then each of `powders` with
/// a further seed. `scene` stands alone (its powder file is in its text).
std::vector<Variant> powder_variants(const Scene& scene, const PowderRegion& region,
                                     const std::vector<std::vector<double>>& powders, int seeds);

/// One measure of `runs`: the best powder's with `seeds` seeds, then one for each powder. Angles count round
/// the circle. NaN where a run has no value.
results::SpreadFigure spread_of(const results::ComparedMeasure& measure,
                                const std::vector<results::ComparedRun>& runs, std::size_t seeds);

/// The figures that are compared, from the results in `directory` of powder_variants() in that order.
results::PowderSpread powder_spread(const std::filesystem::path& directory, const PowderRegion& region,
                                    const std::vector<std::vector<double>>& powders, int seeds);

}  // namespace diefill::process::calibration
