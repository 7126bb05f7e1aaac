// Grain models A to D: mass, moments, volume, size (Bierwisch 2009, section 2.2).
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/engine/engine_test_support.h"

namespace diefill::engine {
namespace {

/// Volume of the union of six unit spheres at +-e, over that of one. For fixed x, y the union of the z
/// intervals is found exactly; x, y by the midpoint rule on one eighth (the body is symmetric).
double union_of_model_c(int cells) {
  const double step = 2.0 / cells;
  double volume = 0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const double x = (i + 0.5) * step, y = (j + 0.5) * step;
      // Length of the union within z >= 0 of four spheres in the plane z = 0 and of the one at +z: the
      // former hold [0, half], the latter [1 - c, 1 + c], and so does its mirror image for [0, c - 1].
      double half = 0;
      for (const auto& [cx, cy] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}})
        half = std::max(half, std::sqrt(std::max(0.0, 1 - (x - cx) * (x - cx) - (y - cy) * (y - cy))));
      const double c = std::sqrt(std::max(0.0, 1 - x * x - y * y));
      volume += std::max(half, 1 + c) * (c > 0) - std::max(0.0, 1 - c - half) * (c > 0) + half * (c <= 0);
    }
  return 8 * volume * step * step / (4.0 / 3.0 * std::numbers::pi);
}

TEST(GrainShape, ModelCHasTheVolumeOfItsUnion) {
  const double radius = 8.9e-5;
  const double sphere = 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3);
  const double quadrature = union_of_model_c(2000);
  EXPECT_NEAR(quadrature, 4.7926, 1e-3);
  EXPECT_NEAR(model_c(radius, 7.63e-8).solid_volume / sphere, quadrature, 1e-3);
}

TEST(GrainShape, ModelsHaveEqualSolidVolume) {
  const double volume = thesis_shape(Model::a).solid_volume;
  for (const Model model : {Model::b, Model::c, Model::d})
    EXPECT_NEAR(thesis_shape(model).solid_volume, volume, 2e-3 * volume);
}

TEST(GrainShape, SizesAreTwoFourAndSixRadii) {
  EXPECT_DOUBLE_EQ(2 * half_size(model_a(1, 1)), 2);
  EXPECT_DOUBLE_EQ(2 * half_size(model_b(1, 1)), 2);
  EXPECT_DOUBLE_EQ(2 * half_size(model_c(1, 1)), 4);
  EXPECT_DOUBLE_EQ(2 * half_size(model_d(1, 1)), 6);
}

TEST(GrainShape, MomentsHoldTheSpheresOwnInertia) {
  const auto over_mass_and_radius = [](const GrainShape& shape) {
    return Eigen::Vector3d(shape.inertia / (shape.mass * shape.sphere_radius * shape.sphere_radius));
  };
  const Eigen::Vector3d ones = Eigen::Vector3d::Ones();
  EXPECT_LT((over_mass_and_radius(thesis_shape(Model::b)) - 0.4 * ones).norm(), 1e-12);
  EXPECT_LT((over_mass_and_radius(thesis_shape(Model::c)) - 16.0 / 15.0 * ones).norm(), 1e-12);
  EXPECT_LT((over_mass_and_radius(thesis_shape(Model::d)) - 94.0 / 35.0 * ones).norm(), 1e-12);
}

TEST(GrainShape, OnlyModelADoesNotRotate) {
  EXPECT_FALSE(thesis_shape(Model::a).rotates);
  for (const Model model : {Model::b, Model::c, Model::d}) EXPECT_TRUE(thesis_shape(model).rotates);
}

TEST(GrainShape, SpheresOfModelDTouchAndThoseOfModelCMeetInTheCentre) {
  const auto d = thesis_shape(Model::d);
  ASSERT_EQ(d.spheres(), 7U);
  EXPECT_EQ(d.sphere_offsets[0].norm(), 0);
  for (std::size_t k = 1; k < 7; ++k) EXPECT_DOUBLE_EQ(d.sphere_offsets[k].norm(), 2 * d.sphere_radius);
  const auto c = thesis_shape(Model::c);
  ASSERT_EQ(c.spheres(), 6U);
  for (const auto& offset : c.sphere_offsets) EXPECT_DOUBLE_EQ(offset.norm(), c.sphere_radius);
}

/// Inertia tensor about the origin of equal solid spheres at `offsets`.
Eigen::Matrix3d tensor_of(const std::vector<Eigen::Vector3d>& offsets, double radius, double mass) {
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  const double share = mass / static_cast<double>(offsets.size());
  for (const auto& b : offsets)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        tensor(i, j) += share * ((i == j ? b.squaredNorm() + 0.4 * radius * radius : 0) - b[i] * b[j]);
  return tensor;
}

TEST(GrainShape, AnyClumpStandsInItsPrincipalFrame) {
  const std::vector<Eigen::Vector3d> offsets = {{3, 1, 0}, {4.5, 2, 0.3}, {2, 2.5, 1}, {3, 0, 2}};
  const double radius = 0.8, mass = 2.5;
  const auto clump = rigid_grain(radius, offsets, mass, 7.0);
  ASSERT_EQ(clump.spheres(), 4U);
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const auto& offset : clump.sphere_offsets) centre += offset;
  EXPECT_LT(centre.norm(), 1e-14);
  const Eigen::Matrix3d tensor = tensor_of(clump.sphere_offsets, radius, mass);
  EXPECT_LT((tensor - Eigen::Matrix3d(clump.inertia.asDiagonal())).norm(), 1e-13 * tensor.norm());
  // Moving and turning the frame changes no distance and no handedness.
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_NEAR((clump.sphere_offsets[i] - clump.sphere_offsets[j]).norm(),
                  (offsets[i] - offsets[j]).norm(), 1e-13);
  const auto handedness = [](const std::vector<Eigen::Vector3d>& b) {
    return (b[1] - b[0]).cross(b[2] - b[0]).dot(b[3] - b[0]);
  };
  EXPECT_NEAR(handedness(clump.sphere_offsets), handedness(offsets), 1e-12);
}

TEST(GrainShape, RefusesGrainsThatCannotBe) {
  EXPECT_THROW(rigid_grain(1, {}, 1, 1), std::invalid_argument);
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(rigid_grain(bad, {Eigen::Vector3d::Zero()}, 1, 1), std::invalid_argument);
    EXPECT_THROW(rigid_grain(1, {Eigen::Vector3d::Zero()}, bad, 1), std::invalid_argument);
    EXPECT_THROW(rigid_grain(1, {Eigen::Vector3d::Zero()}, 1, bad), std::invalid_argument);
  }
}

}  // namespace
}  // namespace diefill::engine
