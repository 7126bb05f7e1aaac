// Finds where in the powder a limit is exceeded most, for messages of a run that has left the method's range.
// Used only then, because it checks every grain or contact.
#pragma once

#include <cstddef>
#include <string>

namespace diefill::engine {

struct Grains;
class Simulation;

/// The grain of largest speed.
struct FastestGrain {
  std::size_t grain = 0;  ///< place in Grains
  double speed = 0;       ///< m/s
};
FastestGrain fastest_grain(const Grains& grains);
/// The grain that moves by most radii of its spheres in a step.
FastestGrain fastest_for_its_size(const Simulation& simulation);

/// Two grains whose spheres overlapped most in the last step.
struct DeepestPair {
  std::size_t first = 0, second = 0;  ///< places in Grains
  double overlap = 0;                 ///< m; 0: nothing touches
};
DeepestPair deepest_pair(const Simulation& simulation);

/// "grain 12 at (1.00, 2.00, 3.00) mm".
std::string grain_text(const Grains& grains, std::size_t grain);

}  // namespace diefill::engine
