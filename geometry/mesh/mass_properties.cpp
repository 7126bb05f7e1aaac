#include "geometry/mesh/mass_properties.h"

#include <Eigen/LU>

namespace diefill::geometry {

MassProperties mass_properties(const Mesh& mesh) {
  // From the middle of the box, so that differences of large numbers do not round small parts away.
  const Box box = mesh.bounding_box();
  const Eigen::Vector3d middle = 0.5 * (box.lower + box.upper);
  // Second moments of the tetrahedron with corners 0 and the unit vectors.
  const Eigen::Matrix3d unit =
      (Eigen::Matrix3d::Ones() + Eigen::Matrix3d(Eigen::Matrix3d::Identity())) / 120.0;
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    Eigen::Matrix3d corners;
    for (Eigen::Index k = 0; k < 3; ++k)
      corners.col(k) = mesh.vertices[static_cast<std::size_t>(triangle[k])] - middle;
    const double determinant = corners.determinant();
    volume += determinant / 6;
    first += determinant / 24 * corners.rowwise().sum();
    second += determinant * corners * unit * corners.transpose();
  }
  MassProperties properties;
  properties.volume = volume;
  const Eigen::Vector3d offset = first / volume;
  properties.centre = middle + offset;
  const Eigen::Matrix3d about_centre = second - volume * offset * offset.transpose();
  properties.inertia = about_centre.trace() * Eigen::Matrix3d::Identity() - about_centre;
  return properties;
}

}  // namespace diefill::geometry
