// Set-ups that can be computed but hardly be meant: powder beside the shoe, a shoe that hangs above the die,
// is narrower than the cavity or never comes to it, a punch beside the die, powder for half a cavity.
#pragma once

#include <string>
#include <vector>

#include "process/run/tooling.h"

namespace diefill::process {

/// One of them. The places are for a picture.
struct SetupFinding {
  std::string words;                    ///< one line: what, with numbers, and what to do
  std::vector<Eigen::Vector3d> places;  ///< m, laboratory frame
};

/// All that is found; none for most scenes.
std::vector<SetupFinding> setup_findings(const Scene& scene, const Tooling& tooling);

/// What the shoe does: hangs above the die, leaves part of the cavity out, or is out of scale.
std::vector<SetupFinding> shoe_findings(const Scene& scene, const Tooling& tooling);

/// Steps that let powder in with a rate that their boxes cannot give. Throws SceneError for a box in which no
/// grain has room while its step is on: the step would wait for ever.
std::vector<SetupFinding> inflow_findings(const Scene& scene, const Tooling& tooling);

/// Begins the lines among a run's warnings that say what was hardly meant.
inline constexpr const char* kAlert = "WARNING: ";

}  // namespace diefill::process
