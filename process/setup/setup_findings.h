// Set-ups that can be computed but are probably mistakes: powder beside the shoe or above its rim, a shoe
// above the die, narrower than the cavity, never over it, closed below or over the edge of the table, grains
// too coarse for a cavity, a punch beside the die, too little powder, a zone beside all, walls or stiffness
// other than those that the powder was fitted with.
#pragma once

#include <string>
#include <vector>

#include "process/tooling/tooling.h"

namespace diefill::process {

/// One of them. The places are for a picture.
struct SetupFinding {
  std::string words;                    ///< one line: what, with numbers, and what to do
  std::vector<Eigen::Vector3d> places;  ///< m, laboratory frame
};

/// All findings; none for most scenes. Throws SceneError for steps that would never end (inflow_findings(),
/// unreachable_mass.h).
std::vector<SetupFinding> setup_findings(const Scene& scene, const Tooling& tooling);

/// A pour box outside the shoe, and powder higher than the walls around it.
std::vector<SetupFinding> pour_findings(const Scene& scene, const Tooling& tooling);

/// Shoes whose bottom is closed below all powder. Steps must have been prepared.
std::vector<SetupFinding> shoe_floor_findings(const Scene& scene, const Tooling& tooling);

/// Cavities that the scene's grains cannot run into.
std::vector<SetupFinding> cavity_findings(const Scene& scene, const Tooling& tooling);

/// Motions that carry the shoe's opening over the edge of the table. Steps must have been prepared.
std::vector<SetupFinding> table_findings(const Scene& scene, const Tooling& tooling);

/// Findings about the shoe: too high above the die, misses part of the cavity, or is out of scale.
std::vector<SetupFinding> shoe_findings(const Scene& scene, const Tooling& tooling);

/// Steps whose boxes cannot supply their inflow rate. Throws SceneError for a box without room for a grain
/// while its step is active: the step would never end. The same for half of the box in a half model.
std::vector<SetupFinding> inflow_findings(const Scene& scene, const Tooling& tooling);

/// Sections, heaps and zones of [measure] that meet neither tools nor powder.
std::vector<SetupFinding> measure_findings(const Scene& scene, const Tooling& tooling);

/// [suction] of a tool that no step moves up or down. Steps must have been prepared.
std::vector<SetupFinding> suction_findings(const Scene& scene);

/// Prefix of those warnings of a run that point to a likely mistake.
inline constexpr const char* kAlert = "WARNING: ";

}  // namespace diefill::process
