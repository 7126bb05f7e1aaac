// Orders points along a Morton curve: near in space, near in memory.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/numerics/thread_pool.h"

namespace diefill::engine {

/// Indices of `points` (m) sorted by their cell of edge `cell` (m) along a Morton curve; equal cells keep
/// their order.
std::vector<std::uint32_t> spatial_order(const std::vector<Eigen::Vector3d>& points, double cell,
                                         ThreadPool& pool);

}  // namespace diefill::engine
