// The powder's spheres one by one, derived from grains for programs that draw points (ParaView).
#pragma once

#include <cstdint>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::results {

/// Arrays over basic spheres.
struct SphereView {
  std::vector<Eigen::Vector3d> centre;  ///< m, laboratory frame
  std::vector<double> radius;           ///< m
  std::vector<double>
      solid_fraction;  ///< of the sphere's grain, NaN where its cell is open or was not measured
  std::vector<std::uint64_t> grain;  ///< id of the sphere's grain, or its number where grains have no ids
};

/// Empty for powder without orientations or without spheres.
SphereView view_spheres(const FillResult& result);

}  // namespace diefill::results
