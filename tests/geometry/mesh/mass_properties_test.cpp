// Volume, centre and moments of inertia of meshes against closed forms.
#include "geometry/mesh/mass_properties.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

TEST(MassProperties, OfABoxFarFromTheOriginAreThoseOfTheClosedForm) {
  const Eigen::Vector3d lower(10, -20, 5), size(0.01, 0.02, 0.03);
  const auto found = mass_properties(sample::box(lower, lower + size));
  const double volume = size.prod();
  EXPECT_NEAR(found.volume, volume, 1e-9 * volume);
  EXPECT_NEAR((found.centre - lower - 0.5 * size).norm(), 0, 1e-9);
  const Eigen::Vector3d squares = size.cwiseAbs2();
  const Eigen::Matrix3d inertia =
      (volume / 12 * (squares.sum() * Eigen::Vector3d::Ones() - squares)).asDiagonal();
  EXPECT_NEAR((found.inertia - inertia).norm(), 0, 1e-9 * inertia.norm());
}

TEST(MassProperties, TurnWithTheSolid) {
  const Mesh box = sample::box({0, 0, 0}, {0.01, 0.02, 0.03});
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const auto straight = mass_properties(box), turned = mass_properties(transformed(box, turn, {0.1, 0, 0}));
  EXPECT_NEAR((turned.inertia - turn * straight.inertia * turn.transpose()).norm(), 0,
              1e-12 * straight.inertia.norm());
  EXPECT_NEAR((turned.centre - turn * straight.centre - Eigen::Vector3d(0.1, 0, 0)).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace diefill::geometry
