// What the powder does to a wall body.
#pragma once

#include <Eigen/Core>

namespace diefill::engine {

/// Force and torque of the powder on a wall body. Torque about the origin of the body's frame.
struct WallLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< N m
};

}  // namespace diefill::engine
