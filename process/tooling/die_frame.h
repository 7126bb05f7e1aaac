// The frame that results are in: positions are transformed to where the scene places the die, wherever it has
// been moved. A scene without a die has its results in the laboratory frame.
#pragma once

#include <vector>

#include "engine/walls/walls.h"
#include "process/results/moved_frame.h"
#include "process/tooling/tooling.h"

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process {

/// The cavity as results describe it; azimuth 0 is along x.
results::CavityState cavity_state(const geometry::Cavity& found);
/// All cavities, the largest first; none where nothing is enclosed.
std::vector<results::CavityState> cavity_states(const Tooling& tooling);

/// The die's frame at one time.
class DieFrame : public results::MovedFrame {
 public:
  explicit DieFrame(const engine::BodyMotion& die) : MovedFrame(die.rotation, die.translation) {}
  /// A body as it stands in the die's frame; at rest, unless the die is at its initial pose.
  engine::BodyMotion pose(const engine::BodyMotion& body) const;
};

/// The frame that results are in, as it is now.
DieFrame die_frame(const engine::Simulation& simulation, const Tooling& tooling);

/// kg of powder whose grain centres lie in one of the cavities now.
double filled_mass(const engine::Simulation& simulation, const Tooling& tooling);

}  // namespace diefill::process
