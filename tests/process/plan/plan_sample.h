// A scene to plan without CAD files: the shoe and die of the sample scene as boxes, a cavity by hand, a pilot
// of known costs.
#pragma once

#include <string>

#include "process/plan/plan.h"
#include "tests/process/scene_files.h"
#include "tests/support/scene_text.h"

namespace diefill::process::plan {

/// m: narrowest width of the cavity.
inline constexpr double kWidth = 4.5e-3;

/// A box, closed and outward.
geometry::Mesh box_mesh(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper);

/// The sample scene with `step` in place of its passage, which needs no preparing.
class PlannedScene {
 public:
  explicit PlannedScene(support::SceneTables tables = waiting());
  /// A scene whose only step is a wait of 0.3 s.
  static support::SceneTables waiting();

  SceneFolder folder;
  Scene scene;
  Tooling tooling;
};

/// A plan of that scene, whose pilot found 10 ns a sphere and step for the fall, 40 for motion, 20 for rest.
Plan sample_plan(const PlannedScene& planned);

}  // namespace diefill::process::plan
