// Measures every cavity of a filled die.
#pragma once

#include "process/results/fill_result.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// Fields, figures and verdict of the result's cavity and, under their numbers, of the smaller ones
/// (other_cavities.h). `sections` are the planes that the scene asks for. `result` holds powder, solid
/// fractions, summary and the topics so far.
void measure_cavities(results::FillResult& result, const Scene& scene, const Tooling& tooling,
                      const std::vector<results::SectionPlane>& sections);

}  // namespace diefill::process
