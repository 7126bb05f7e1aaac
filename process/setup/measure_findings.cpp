// Measured places that neither tools nor powder reach, and air that no tool draws.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "process/machine/actions/powder_inflow.h"
#include "process/machine/free_motion.h"
#include "process/scene/zones.h"
#include "process/setup/setup_findings.h"
#include "process/tooling/stages.h"

namespace diefill::process {

namespace {

constexpr double kStill = 1e-9;  // m and m/s, of rounding

/// Box round the tools, the room they need and the powder at the start or as it comes in.
geometry::Box tools_and_powder(const Scene& scene, const Tooling& tooling) {
  geometry::Box box = tooling.all;
  if (tooling.standing.size().minCoeff() >= 0) box.include(tooling.standing);
  box.include(scene.pour.lower);
  box.include(scene.pour.upper);
  for (const auto& step : scene.steps)
    if (const PowderInflow* inflow = step->inflow()) {
      box.include(inflow->lower);
      box.include(inflow->upper);
    }
  return box;
}

bool meets(const geometry::Box& box, const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  return (lower.array() <= box.upper.array()).all() && (upper.array() >= box.lower.array()).all();
}

bool meets(const geometry::Box& box, const SectionSpec& section) {
  const Eigen::Vector3d middle = 0.5 * (box.lower + box.upper), half = 0.5 * box.size();
  return std::abs(section.normal.dot(middle - section.origin)) <= section.normal.cwiseAbs().dot(half);
}

bool meets(const geometry::Box& box, const Zone& zone) {
  if (!meets(box, zone.lower, zone.upper)) return false;
  double nearest = 0, farthest = 0;  // squares of distances of what is left of the box from the axis
  for (Eigen::Index k = 0; k < 2; ++k) {
    const double below = std::max(zone.lower[k], box.lower[k]) - zone.axis[k],
                 above = std::min(zone.upper[k], box.upper[k]) - zone.axis[k];
    nearest += std::pow(std::max({below, -above, 0.0}), 2);
    farthest += std::pow(std::max(-below, above), 2);
  }
  return std::sqrt(nearest) < zone.outer_radius && std::sqrt(farthest) > zone.inner_radius;
}

SetupFinding outside(const std::string& kind, const std::string& name, const geometry::Box& box) {
  char text[300];
  const Eigen::Vector3d from = 1e3 * box.lower, to = 1e3 * box.upper;
  std::snprintf(
      text, sizeof text,
      " meets neither tools nor powder, which lie from (%.4g, %.4g, %.4g) to (%.4g, %.4g, %.4g) mm: "
      "nothing is measured there; correct its position",
      from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
  return {"[[measure." + kind + "]] \"" + name + "\"" + text, {}};  // its place would shrink the picture
}

/// Whether a step moves the tool up or down. One whose way depends on the powder counts as such.
bool moves_vertically(const Scene& scene, const std::string& tool) {
  const Stages stages(scene);
  if (!stages.moves(tool)) return false;
  for (const auto& step : scene.steps) {
    const auto tools = step->tools();
    if (std::find(tools.begin(), tools.end(), tool) == tools.end()) continue;
    if (step->control() != nullptr || free_motion_of(*step) != nullptr) return true;
  }
  constexpr int kInstants = 200;
  const auto states = predicted(stages, kSettlingGuess);
  const auto times = instants(stages, states, kInstants);
  return std::any_of(times.begin(), times.end(), [&](double time) {
    const ToolPose pose = pose_of(stages, states, tool, time);
    return std::abs(pose.translation.z()) > kStill || std::abs(pose.velocity.z()) > kStill;
  });
}

}  // namespace

std::vector<SetupFinding> measure_findings(const Scene& scene, const Tooling& tooling) {
  std::vector<SetupFinding> findings;
  const geometry::Box box = tools_and_powder(scene, tooling);
  for (const SectionSpec& section : scene.measure.sections)
    if (!meets(box, section)) findings.push_back(outside("section", section.name, box));
  for (const HeapSpec& heap : scene.measure.heaps)
    if (!meets(box, heap.from, heap.to)) findings.push_back(outside("heap", heap.name, box));
  for (const Zone& zone : zones_in(scene.text))
    if (!meets(box, zone)) findings.push_back(outside("zone", zone.name, box));
  return findings;
}

std::vector<SetupFinding> suction_findings(const Scene& scene) {
  if (!scene.suction || moves_vertically(scene, scene.suction->tool)) return {};
  return {{"[suction]: tool \"" + scene.suction->tool +
               "\" never moves up or down, so it draws no air: the air only slows powder that falls into the "
               "cavity; name the punch that moves, or remove [suction]",
           {}}};
}

}  // namespace diefill::process
