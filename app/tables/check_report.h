// Report of `check` about the tools: as text, as JSON, and as marks on a picture.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "process/setup/setup_findings.h"
#include "process/tooling/examination/diagnosis.h"
#include "render/scene3d/findings.h"

namespace diefill::app {

/// A tool's mesh: size, state, repairs, symmetry (none: not searched for), wall spheres where there are any.
void print_tool(const process::Tool& tool, const geometry::Symmetry* symmetry);
/// How neighbouring tools fit.
void print_pairs(const process::Diagnosis& diagnosis);
/// The cavities.
void print_cavities(const process::Tooling& tooling);

/// All that the above print, lengths in m. `diagnosis` may be empty when tools were refused.
nlohmann::ordered_json tools_as_json(const process::Tooling& tooling, const process::Diagnosis& diagnosis);

/// Faults of the meshes as read from the files, gaps that powder enters, overlaps, the narrowest place.
std::vector<render::FindingMark> marks_of(const process::Tooling& tooling,
                                          const process::Diagnosis& diagnosis);
/// Where powder is poured, and what was found about the set-up.
std::vector<render::FindingMark> marks_of(const process::Scene& scene,
                                          const std::vector<process::SetupFinding>& setup);
/// The path of a moving tool through the steps, which must have been prepared.
render::FindingMark path_marker(const process::Scene& scene, const process::Tool& tool);
nlohmann::ordered_json setup_as_json(const std::vector<process::SetupFinding>& setup);
/// A block of the lines under the word WARNING; nothing for none.
void print_alerts(const std::vector<std::string>& lines);
std::vector<std::string> finding_lines(const std::vector<process::SetupFinding>& setup);
std::vector<render::MarkedPart> parts_of(const process::Tooling& tooling);

}  // namespace diefill::app
