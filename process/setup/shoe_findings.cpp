// Where the opening of the shoe goes, against the cavity that it is to fill.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "process/powder/material.h"
#include "process/setup/setup_findings.h"
#include "process/tooling/examination/plan_view.h"
#include "process/tooling/examination/tool_scale.h"
#include "process/tooling/stages.h"

namespace diefill::process {

namespace {

constexpr int kDense = 400;            // instants of a step
constexpr int kCells = 24;             // each way, of the cavity seen from above
constexpr double kJustAbove = 5e-4;    // m above the shoe's lower edge, where its opening is taken
constexpr double kJustBelow = 2e-4;    // m below the fill plane, where the cavity is taken
constexpr double kMaxLeftOut = 0.02;   // share of the cavity
constexpr double kOutOfScale = 6;      // opening over cavity
constexpr double kUsualOpening = 1.5;  // the same, where a unit is guessed

/// All poses of a tool seen from the die.
std::vector<ToolPose> poses_over_die(const Scene& scene, const Tooling& tooling, const std::string& tool) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  const std::string& die = tooling.tools[tooling.die].spec.name;
  std::vector<ToolPose> poses(1);
  for (const double time : instants(stages, states, kDense)) {
    const ToolPose below = pose_of(stages, states, die, time), above = pose_of(stages, states, tool, time);
    ToolPose pose;
    pose.rotation = below.rotation.transpose() * above.rotation;
    pose.translation = below.rotation.transpose() * (above.translation - below.translation);
    poses.push_back(pose);
  }
  return poses;
}

/// Places of the cavities at the fill plane, m.
std::vector<Eigen::Vector3d> fill_plane_points(const Tooling& tooling) {
  std::vector<Eigen::Vector3d> places;
  const geometry::Box box = tooling.all_cavities().box;
  const Eigen::Vector3d size = box.size();
  std::vector<PlanView> views;
  for (const Tool& tool : tooling.tools)
    if (tool.spec.role != ToolRole::shoe) views.emplace_back(tool.mesh, tooling.fill_plane - kJustBelow);
  for (int j = 0; j < kCells; ++j)
    for (int i = 0; i < kCells; ++i) {
      const Eigen::Vector3d place(box.lower.x() + size.x() * (i + 0.487) / kCells,
                                  box.lower.y() + size.y() * (j + 0.513) / kCells, tooling.fill_plane);
      const bool steel = std::any_of(views.begin(), views.end(),
                                     [&](const PlanView& view) { return view.solid(place.head<2>()); });
      if (!steel) places.push_back(place);
    }
  return places;
}

bool over(const geometry::Box& box, const geometry::Box& cavity) {
  return (box.lower.head<2>().array() < cavity.upper.head<2>().array()).all() &&
         (box.upper.head<2>().array() > cavity.lower.head<2>().array()).all();
}

/// m, least height of the shoe's lower edge above the fill plane while it is over the cavity; negative
/// infinity when it never is.
struct Pass {
  double height = std::numeric_limits<double>::infinity();
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< m, lower edge then
  bool any = false;
};

Pass pass_of(const Tool& shoe, const Tooling& tooling, const std::vector<ToolPose>& poses) {
  Pass pass;
  const geometry::Box cavity = tooling.all_cavities().box;
  for (const ToolPose& pose : poses) {
    geometry::Box box = shoe.mesh.bounding_box();
    if (pose.rotation.isIdentity(1e-9)) {
      box.lower += pose.translation;
      box.upper += pose.translation;
    } else {
      box = geometry::transformed(shoe.mesh, pose.rotation, pose.translation).bounding_box();
    }
    if (!over(box, cavity)) continue;
    pass.any = true;
    const double height = box.lower.z() - tooling.fill_plane;
    if (height >= pass.height) continue;
    pass.height = height;
    pass.place = {0.5 * (box.lower.x() + box.upper.x()), 0.5 * (box.lower.y() + box.upper.y()),
                  box.lower.z()};
  }
  return pass;
}

/// The places of the cavity that the opening never comes over.
std::vector<Eigen::Vector3d> left_out(const Opening& opening, const std::vector<ToolPose>& poses,
                                      const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> rest;
  for (const auto& place : points) {
    const bool met = std::any_of(poses.begin(), poses.end(), [&](const ToolPose& pose) {
      return opening.contains((pose.rotation.transpose() * (place - pose.translation)).head<2>());
    });
    if (!met) rest.push_back(place);
  }
  return rest;
}

/// What unit would bring the opening to the size of the cavity; empty when none does.
std::string scale_of(const Tool& shoe, const Opening& opening, const geometry::Box& cavity) {
  const double ratio = opening.size().maxCoeff() / cavity.size().head<2>().maxCoeff();
  double best = 1, nearest = std::abs(std::log(ratio / kUsualOpening));
  for (const double factor : unit_factors()) {
    const double off = std::abs(std::log(factor * ratio / kUsualOpening));
    if (off >= nearest || factor * ratio < 0.95) continue;
    nearest = off;
    best = factor;
  }
  return best == 1 ? "" : unit_advice(shoe, best);
}

SetupFinding not_covered(const Tool& shoe, const Opening& opening, const geometry::Box& cavity, double share,
                         std::vector<Eigen::Vector3d> rest) {
  const Eigen::Vector2d open = 1e3 * opening.size();
  const Eigen::Vector3d size = 1e3 * cavity.size();
  char text[400];
  std::snprintf(text, sizeof text,
                share >= 0.999
                    ? "the opening of shoe \"%s\" never passes over the cavity (x %.4g to %.4g mm, y %.4g to "
                      "%.4g mm): check its start position and the direction and travel of its steps"
                    : "the opening of shoe \"%s\" never passes over part of the cavity (x %.4g to %.4g mm, y "
                      "%.4g to %.4g mm)",
                shoe.spec.name.c_str(), 1e3 * cavity.lower.x(), 1e3 * cavity.upper.x(),
                1e3 * cavity.lower.y(), 1e3 * cavity.upper.y());
  std::string words = text;
  if (share < 0.999) {
    std::snprintf(text, sizeof text,
                  ": %.0f %% of it, because the opening measures %.4g x %.4g mm and the cavity %.4g x %.4g "
                  "mm; use a larger shoe or move it farther",
                  100 * share, open.x(), open.y(), size.x(), size.y());
    words += text;
  }
  const std::string scale = scale_of(shoe, opening, cavity);
  return {words + (scale.empty() || opening.size().maxCoeff() > 0.5 * cavity.size().head<2>().maxCoeff()
                       ? ""
                       : ". " + scale),
          std::move(rest)};
}

void check_shoe(const Scene& scene, const Tooling& tooling, const Tool& shoe,
                std::vector<SetupFinding>& findings) {
  const auto poses = poses_over_die(scene, tooling, shoe.spec.name);
  const geometry::Box cavity = tooling.all_cavities().box;
  const Pass pass = pass_of(shoe, tooling, poses);
  const double sphere = 2 * smallest_sphere(engine_settings(scene, 1.0));
  if (pass.any && pass.height > sphere) {
    char text[300];
    std::snprintf(text, sizeof text,
                  "shoe \"%s\" is %.3g mm above the fill plane, z = %.4g mm, where it passes the cavity: "
                  "spheres of %.3g mm leak out below it; lower it by that distance",
                  shoe.spec.name.c_str(), 1e3 * pass.height, 1e3 * tooling.fill_plane, 1e3 * sphere);
    findings.push_back({text, {pass.place}});
  }
  const double bottom = shoe.mesh.bounding_box().lower.z();
  const Opening opening(shoe.mesh, bottom + std::min(kJustAbove, 0.1 * shoe.mesh.bounding_box().size().z()));
  if (opening.empty()) return;  // open on a side: what it holds is not known
  const auto points = fill_plane_points(tooling);
  auto rest = left_out(opening, poses, points);
  const double share =
      points.empty() ? 0 : static_cast<double>(rest.size()) / static_cast<double>(points.size());
  if (share > kMaxLeftOut) findings.push_back(not_covered(shoe, opening, cavity, share, std::move(rest)));
  const double ratio = opening.size().maxCoeff() / cavity.size().head<2>().maxCoeff();
  const double die = tooling.tools[tooling.die].mesh.bounding_box().size().head<2>().maxCoeff();
  if (ratio > kOutOfScale && opening.size().maxCoeff() > die) {
    const std::string scale = scale_of(shoe, opening, cavity);
    if (!scale.empty()) findings.push_back({scale, {shoe.mesh.bounding_box().upper}});
  }
}

}  // namespace

std::vector<SetupFinding> shoe_findings(const Scene& scene, const Tooling& tooling) {
  std::vector<SetupFinding> findings;
  if (scene.numerics.period[0] || scene.numerics.period[1] || scene.numerics.period[2])
    return findings;  // walls of such shoes are plates
  const Stages stages(scene);
  const bool die_moves = stages.moves(tooling.tools[tooling.die].spec.name);
  const auto shoes = std::count_if(scene.tools.begin(), scene.tools.end(),
                                   [](const ToolSpec& tool) { return tool.role == ToolRole::shoe; });
  for (const Tool& tool : tooling.tools)
    if (shoes == 1 && tool.spec.role == ToolRole::shoe && (die_moves || stages.moves(tool.spec.name)))
      check_shoe(scene, tooling, tool, findings);
  return findings;
}

}  // namespace diefill::process
