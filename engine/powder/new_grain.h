// A grain to be added to a simulation.
#pragma once

#include <Eigen/Core>

#include "engine/powder/grains.h"
#include "engine/powder/particle_types.h"

namespace diefill::engine {

/// A grain to be added.
struct NewGrain {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();          ///< m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< m/s
  Quaternion orientation = {1, 0, 0, 0};                       ///< (w, x, y, z), body to laboratory
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s, laboratory frame
  TypeNumber kind = 0;                                         ///< number in SimulationSettings::types
};

}  // namespace diefill::engine
