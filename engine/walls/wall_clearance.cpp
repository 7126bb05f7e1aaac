#include "engine/walls/wall_clearance.h"

#include <algorithm>

namespace diefill::engine {

double clearance_of(const WallBody& body, const BodyMotion& pose, const Eigen::AlignedBox3d& points,
                    double reach) {
  const Eigen::Vector3d &lower = points.min(), &upper = points.max();
  const Eigen::Vector3d middle = pose.rotation.transpose() * (0.5 * (lower + upper) - pose.translation);
  const Eigen::Vector3d beyond = (body.lower() - middle).cwiseMax(middle - body.upper()).cwiseMax(0.0);
  return std::max(0.0, beyond.norm() - 0.5 * (upper - lower).norm() - reach);
}

}  // namespace diefill::engine
