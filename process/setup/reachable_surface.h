// Which surfaces of the tools powder can touch during a scene.
#pragma once

#include <memory>

#include "geometry/reach/reach.h"
#include "process/scene/scene.h"

namespace diefill::process {

struct Tooling;

/// Floods the free space from the pour box through all the poses the scene's steps give the tools.
class ReachableSurface {
 public:
  /// `grain_diameter` d in m. Steps must have been prepared.
  ReachableSurface(const Scene& scene, const Tooling& tooling, double grain_diameter);
  /// True if powder can come to this point (m) of tool k, at its pose in the scene, with the given outward
  /// normal.
  bool operator()(std::size_t tool, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const;

 private:
  std::unique_ptr<geometry::Reach> reach_;
  double period_half_[3];
  double margin_ = 0;
  geometry::Box falls_here_;  ///< m, where powder is poured round tools; empty where none is in its way
};

}  // namespace diefill::process
