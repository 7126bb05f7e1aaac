// Dies with several cavities: figures, profiles and verdict of all but the largest.
#pragma once

#include <functional>
#include <vector>

#include "geometry/cavity/cavity.h"
#include "process/results/fill_result.h"

namespace diefill::process {

/// Measures the result's cavity: fields, figures, verdict.
using MeasureCavity = std::function<void(results::FillResult&)>;

/// Adds `others` (in the die's frame) to `result`, whose own cavity is number 1. Each is measured as that one
/// was; its figures are added under `cavity_<n>_...`, its profiles after those of the first with
/// ", cavity <n>" in their names, its verdict and reasons among the topics; and a warning says that there are
/// several. `result` holds the powder and its solid fraction; what it has of its own cavity stays. Nothing
/// for no others.
void add_other_cavities(results::FillResult& result, const std::vector<geometry::Cavity>& others,
                        const MeasureCavity& measure = {});

}  // namespace diefill::process
