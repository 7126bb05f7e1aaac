// What grains of shaded views can be coloured by.
#pragma once

#include <string>
#include <vector>

#include "process/results/fill_result.h"
#include "render/scene3d/snapshot.h"

namespace diefill::app {

/// Names of --colour-by, the first is the default.
const std::vector<std::string>& grain_colours();

/// Puts into `options` the values and words of `by` for `result`, which is `whole` at some instant. Throws
/// std::invalid_argument or process::SceneError where the results do not hold what it needs.
void colour_grains(render::ViewOptions& options, const std::string& by, const results::FillResult& result,
                   const results::FillResult& whole);

/// One scale for all instants of all results where none is given, so that a colour means the same in all of
/// them: the solid fraction that of the runs' maps and sections, speeds from 0 to what all but a few grains
/// reach at any instant, other values as they are at the ends of the runs. Throws as colour_grains().
void fix_scale(render::ViewOptions& options, const std::string& by,
               const std::vector<const results::FillResult*>& results);

}  // namespace diefill::app
