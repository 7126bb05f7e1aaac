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
  if (!kinds.sphere_radii.empty())
    return *std::max_element(kinds.sphere_radii.begin(), kinds.sphere_radii.end());
  double size = 1;
  for (const double radius : kinds.sphere_radius) size = std::max(size, radius / sphere_radius);
  const double largest =
      sphere_radii.empty() ? sphere_radius : *std::max_element(sphere_radii.begin(), sphere_radii.end());
  return size * largest;
}

namespace {

/// Spheres of a grain of one type: places in one list of centres and radii, and what they are to be enlarged
/// by.
struct TypeSpheres {
  std::size_t first = 0, count = 0;
  double size = 1;
};

std::vector<TypeSpheres> spheres_of_types(const PowderState& powder) {
  const ParticleTypes& kinds = powder.kinds;
  std::vector<TypeSpheres> types;
  std::size_t first = 0;
  for (std::size_t k = 0; k < kinds.spheres.size(); ++k) {
    types.push_back({first, kinds.spheres[k], 1});
    first += kinds.spheres[k];
  }
  if (!types.empty()) return types;
  for (const double radius : kinds.sphere_radius)
    types.push_back({0, powder.sphere_offsets.size(), radius / powder.sphere_radius});
  if (types.empty()) types.push_back({0, powder.sphere_offsets.size(), 1});
  return types;
}

/// Calls visit(grain, type, number of the sphere in the lists of its type) for every sphere.
template <class Visit>
void visit_spheres(const PowderState& powder, const Visit& visit) {
  const auto types = spheres_of_types(powder);
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    const TypeSpheres& type = types[powder.monodisperse() ? 0 : powder.kind[k]];
    for (std::size_t s = 0; s < type.count; ++s) visit(k, type, type.first + s);
  }
}

}  // namespace

std::size_t PowderState::sphere_count() const {
  if (kinds.spheres.empty()) return position.size() * sphere_offsets.size();
  std::size_t count = 0;
  for (std::size_t k = 0; k < position.size(); ++k) count += spheres_of(k);
  return count;
}

std::vector<double> PowderState::radii_of_spheres() const {
  std::vector<double> radii;
  radii.reserve(sphere_count());
  const std::vector<double>& own = kinds.spheres.empty() ? sphere_radii : kinds.sphere_radii;
  visit_spheres(*this, [&](std::size_t, const TypeSpheres& type, std::size_t s) {
    radii.push_back(type.size * (own.empty() ? sphere_radius : own[s]));
  });
  return radii;
}

std::vector<std::uint32_t> PowderState::grains_of_spheres() const {
  std::vector<std::uint32_t> grains;
  grains.reserve(sphere_count());
  visit_spheres(*this, [&](std::size_t k, const TypeSpheres&, std::size_t) {
    grains.push_back(static_cast<std::uint32_t>(k));
  });
  return grains;
}

std::vector<Eigen::Vector3d> PowderState::sphere_centres() const {
  std::vector<Eigen::Vector3d> centres;
  centres.reserve(sphere_count());
  const auto& offsets = kinds.spheres.empty() ? sphere_offsets : kinds.sphere_offsets;
  std::size_t turned = position.size();  // none yet
  Eigen::Matrix3d body_to_lab;
  visit_spheres(*this, [&](std::size_t k, const TypeSpheres& type, std::size_t s) {
    if (k != turned) {
      const Eigen::Vector4d& q = orientation[k];
      body_to_lab = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
      turned = k;
    }
    centres.push_back(position[k] + body_to_lab * (type.size * offsets[s]));
  });
  return centres;
}

}  // namespace diefill::results
