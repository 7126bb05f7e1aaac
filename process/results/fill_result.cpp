#include "process/results/fill_result.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>

namespace diefill::results {

double PowderState::largest_diameter() const {
  return monodisperse() ? grain_diameter : *std::max_element(kinds.diameter.begin(), kinds.diameter.end());
}

std::string PowderState::sizes_text() const {
  char text[80];
  if (monodisperse())
    std::snprintf(text, sizeof text, "%.3g mm", 1e3 * grain_diameter);
  else
    std::snprintf(text, sizeof text, "%.3g to %.3g mm",
                  1e3 * *std::min_element(kinds.diameter.begin(), kinds.diameter.end()),
                  1e3 * largest_diameter());
  return text;
}

double PowderState::largest_sphere_radius() const {
  double size = 1;
  for (const double radius : kinds.sphere_radius) size = std::max(size, radius / sphere_radius);
  const double largest =
      sphere_radii.empty() ? sphere_radius : *std::max_element(sphere_radii.begin(), sphere_radii.end());
  return size * largest;
}

std::vector<Eigen::Vector3d> PowderState::sphere_centres() const {
  std::vector<Eigen::Vector3d> centres;
  centres.reserve(position.size() * sphere_offsets.size());
  for (std::size_t k = 0; k < position.size(); ++k) {
    const Eigen::Vector4d& q = orientation[k];
    const Eigen::Matrix3d body_to_lab = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
    if (monodisperse()) {
      for (const auto& offset : sphere_offsets) centres.push_back(position[k] + body_to_lab * offset);
      continue;
    }
    const double size = sphere_radius_of(k) / sphere_radius;
    for (const auto& offset : sphere_offsets) centres.push_back(position[k] + body_to_lab * (size * offset));
  }
  return centres;
}

}  // namespace diefill::results
