// What is known of the error of a run: measured, each with its source.
#pragma once

#include <string>
#include <vector>

#include "process/scene/scene.h"
#include "process/tooling/tooling.h"

namespace diefill::process::plan {

/// A measured error that applies to a scene.
struct ExpectedError {
  std::string quantity;  ///< such as "mass in the cavity"
  double error = 0;      ///< over the value that it is compared with
  double scatter = 0;    ///< standard deviation of one run over seeds, over the same; 0: not measured
  std::string source;    ///< what it was measured on, and the table
  double extrapolated_beyond = 0;  ///< d/b up to which it was measured; 0: it is not extrapolated
};

/// Lengths of a scene that its grains have to be small against. m, 0: it has none.
struct SceneLengths {
  double cavity = 0;   ///< narrowest width of its cavities
  double opening = 0;  ///< narrowest width of holes right through its tools
  double depth = 0;    ///< of the powder, settled
  bool heap = false;   ///< whether the slope of a heap is measured
};

/// `opening` (m) comes from estimate/openings/openings.h.
SceneLengths lengths_of(const Scene& scene, const Tooling& tooling, double opening);

/// The errors to be expected with grains of this diameter d (m), against grains of no size: the largest over
/// the scenes of grain_size_trends.h, of the same powder where it was measured. Each is that of a line
/// through the origin, hypot(slope, standard error of the slope) d/b; beyond the coarsest grains of its scene
/// the line goes on up to the coarsest that were run in any cavity (3 % more, so that 1/3 counts as 0.33),
/// and coarser grains have no error. With a cavity of mass, mean solid fraction and unevenness; without, of
/// the mass that runs through an opening; with neither, of the powder's solid fraction and the slope of a
/// heap. For presets with a published bed its solid fraction as well. A preset of which the scene changes
/// something counts as another powder: give powder_as_published(). Empty where nothing applies.
std::vector<ExpectedError> expected_errors(const PowderSpec& powder, double grain_diameter,
                                           const SceneLengths& lengths);

/// The largest of them; null where there is none.
const ExpectedError* largest(const std::vector<ExpectedError>& errors);

/// "mass in the cavity 3.1 % (scatter 1.2 %, extrapolated beyond d/b = 0.33)", and so on.
std::string text_of_errors(const std::vector<ExpectedError>& errors);

}  // namespace diefill::process::plan
