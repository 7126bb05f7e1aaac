#include "process/results/fill_result.h"

#include <Eigen/Geometry>

namespace diefill::results {

std::vector<Eigen::Vector3d> PowderState::sphere_centres() const {
  std::vector<Eigen::Vector3d> centres;
  centres.reserve(position.size() * sphere_offsets.size());
  for (std::size_t k = 0; k < position.size(); ++k) {
    const Eigen::Vector4d& q = orientation[k];
    const Eigen::Matrix3d body_to_lab = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
    for (const auto& offset : sphere_offsets) centres.push_back(position[k] + body_to_lab * offset);
  }
  return centres;
}

}  // namespace diefill::results
