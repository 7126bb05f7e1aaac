#include "process/estimate/openings/outlet.h"

#include <algorithm>
#include <cmath>

#include "process/estimate/openings/outline.h"
#include "process/tooling/stages.h"

namespace diefill::process::estimate {

namespace {

constexpr int kHeights = 80;
constexpr double kRound = 1.1;  // longest over shortest line through the middle of a round section
constexpr double kSlit = 3;     // the same of a slit, at least

/// The tools as the steps leave them.
std::vector<geometry::Mesh> tools_at_end(const Scene& scene, const Tooling& tooling) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  double end = 0;
  for (const StepState& state : states) end = std::max(end, state.ended);
  std::vector<geometry::Mesh> meshes;
  for (const Tool& tool : tooling.tools) {
    const ToolPose pose = pose_of(stages, states, tool.spec.name, end);
    meshes.push_back(geometry::transformed(tool.mesh, pose.rotation, pose.translation));
  }
  return meshes;
}

/// What is round a place at one height.
struct Section {
  bool in_the_open = false, in_a_tool = false;
  OutletEstimate opening;  ///< of no width: of another shape
};

Section section_at(const std::vector<geometry::Mesh>& tools, const Scene& scene,
                   const Eigen::Vector2d& middle, double height) {
  Outline outline;
  for (const auto& tool : tools) outline.add(tool, height);
  Section section;
  section.opening.height = height;
  const double x = outline.chord(middle, Eigen::Vector2d::UnitX()),
               y = outline.chord(middle, Eigen::Vector2d::UnitY()),
               slant = outline.chord(middle, Eigen::Vector2d(1, 1).normalized());
  const auto gaps = outline.gaps(middle.y());
  const bool between = std::any_of(gaps.begin(), gaps.end(), [&](const auto& gap) {
    return gap.first < middle.x() && middle.x() < gap.second;
  });
  section.in_the_open = !std::isfinite(x) && !std::isfinite(y);
  section.in_a_tool = !section.in_the_open && !between && std::isfinite(x);
  if (section.in_the_open || section.in_a_tool) return section;
  const auto [least, most] = std::minmax({x, y, slant});
  if (most < kRound * least) {
    section.opening.round = true;
    section.opening.width = (x + y + slant) / 3;
    return section;
  }
  const double narrow = std::min(x, y);
  const auto& period = scene.numerics.period[x < y ? 1 : 0];
  const double length = period ? *period : std::max(x, y);
  if (std::isfinite(length) && (period || length > kSlit * narrow)) {
    section.opening.width = narrow;
    section.opening.length = length;
  }
  return section;
}

/// The narrowest section below `top` with a wider one or the open below it.
std::optional<OutletEstimate> narrowest_section(const std::vector<geometry::Mesh>& tools, const Scene& scene,
                                                double top) {
  const Eigen::Vector2d middle = 0.5 * (scene.pour.lower + scene.pour.upper).head<2>();
  double bottom = top;
  for (const auto& tool : tools) bottom = std::min(bottom, tool.bounding_box().lower.z());
  const double apart = (top - bottom) / kHeights;
  std::optional<OutletEstimate> narrowest;
  for (int k = 0; k <= kHeights && apart > 0; ++k) {
    const Section section = section_at(tools, scene, middle, top - (k + 0.5) * apart);
    const double width = section.opening.width;
    if (section.in_the_open || (narrowest && width > 1.5 * narrowest->width)) return narrowest;
    if (section.in_a_tool) return std::nullopt;
    if (width > 0 && (!narrowest || width <= narrowest->width)) narrowest = section.opening;
  }
  return narrowest;
}

}  // namespace

std::optional<OutletEstimate> outlet_of(const Scene& scene, const Tooling& tooling,
                                        const InflowPowder& powder, double mass) {
  const bool has_shoe = std::any_of(tooling.tools.begin(), tooling.tools.end(),
                                    [](const Tool& tool) { return tool.spec.role == ToolRole::shoe; });
  if (has_shoe || tooling.tools.empty() || !(mass > 0) || !(powder.gravity > 0)) return std::nullopt;
  auto found = narrowest_section(tools_at_end(scene, tooling), scene, scene.pour.lower.z());
  if (!found) return std::nullopt;
  if (found->round) {
    const double width = continuum::effective_width(found->width, powder.grain_diameter);
    found->rate = continuum::beverloo_round(kRoundOpening, powder.density, width, powder.gravity);
  } else {
    const double width = effective_width(found->width, powder);
    found->rate =
        continuum::steady_rate(powder.law.numbers, {powder.density, width, found->length, powder.gravity});
  }
  found->mass = mass;
  return found;
}

}  // namespace diefill::process::estimate
