// SolidQuery against closed forms of boxes and spheres, and against a slow search over all triangles.
#include "geometry/solid/solid_query.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "geometry/mesh/triangle.h"
#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

/// Signed distance to an axis-aligned box about the origin.
double distance_to_box(const Eigen::Vector3d& half, const Eigen::Vector3d& point) {
  const Eigen::Vector3d beyond = point.cwiseAbs() - half;
  return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

Eigen::Vector3d random_point(std::mt19937& random, double extent) {
  std::uniform_real_distribution<double> uniform(-extent, extent);
  const double x = uniform(random);
  const double y = uniform(random);
  return {x, y, uniform(random)};
}

TEST(SolidQuery, MeasuresSignedDistanceToATurnedBox) {
  const Eigen::Vector3d half(0.01, 0.02, 0.005);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const SolidQuery query(transformed(sample::box(-half, half), turn, Eigen::Vector3d::Zero()));
  std::mt19937 random(1);
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3d point = random_point(random, 0.03);
    const double expected = distance_to_box(half, point);
    EXPECT_NEAR(query.signed_distance(turn * point), expected, 1e-16);
    EXPECT_EQ(query.inside(turn * point), expected < 0);
  }
}

TEST(SolidQuery, FindsTheSameFootAsASearchOverAllTriangles) {
  const Mesh mesh = sample::tube(0.008, 0.012, 0.01, 37);
  const SolidQuery query(mesh);
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d point = random_point(random, 0.015);
    double smallest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3i& t : mesh.triangles) {
      const auto corner = [&](int k) { return mesh.vertices[static_cast<std::size_t>(t[k])]; };
      smallest =
          std::min(smallest, (closest_point({corner(0), corner(1), corner(2)}, point).point - point).norm());
    }
    const SolidQuery::Nearest nearest = query.nearest(point);
    EXPECT_NEAR(nearest.distance, smallest, 1e-17);
    EXPECT_NEAR((nearest.point - point).norm(), nearest.distance, 1e-17);
  }
}

void expect_same(const SolidQuery::SignedNearest& answer, const SolidQuery::SignedNearest& expected) {
  EXPECT_EQ(answer.point, expected.point);
  EXPECT_EQ(answer.distance, expected.distance);
  EXPECT_EQ(answer.triangle, expected.triangle);
  EXPECT_EQ(answer.inside, expected.inside);
}

TEST(SolidQuery, AnswersTheSameWhateverTheGuess) {
  const SolidQuery query(sample::tube(0.008, 0.012, 0.01, 37));
  std::mt19937 random(4);
  for (int i = 0; i < 500; ++i) {
    // Half of the points on the tube's axis and in planes of symmetry, where several triangles are equally
    // near.
    Eigen::Vector3d point = random_point(random, 0.015);
    if (i % 2 == 0) point.x() = 0;
    if (i % 4 == 0) point.y() = 0;
    const SolidQuery::SignedNearest plain = query.signed_nearest(point);
    for (const double factor : {0.0, 0.5, 1 - 1e-9, 1 - 1e-12, 1.0, 1 + 1e-12, 1 + 1e-9, 1.5, 100.0}) {
      expect_same(query.signed_nearest(point, factor * plain.distance), plain);
    }
  }
}

TEST(SolidQuery, AnswersTheSameWhereverItAskedBefore) {
  const SolidQuery query(sample::tube(0.008, 0.012, 0.01, 720));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> step(-1, 1), length(-6, -2);
  Eigen::Vector3d point(0.008, 0, 0.005);
  for (int i = 0; i < 3000; ++i) {
    // Mostly a little farther along, now and then far away.
    point += std::pow(10, length(random)) * Eigen::Vector3d(step(random), step(random), step(random));
    if (point.norm() > 0.02) point = Eigen::Vector3d(0, i % 3 == 0 ? 0 : 0.01, 0.005);
    const SolidQuery::SignedNearest plain = query.signed_nearest(point);
    expect_same(query.signed_nearest(point, (1 + 0.1 * (i % 4)) * plain.distance), plain);
  }
}

TEST(SolidQuery, KnowsTheBoreOfATubeFromItsWall) {
  const SolidQuery query(sample::tube(0.008, 0.012, 0.01, 360));
  EXPECT_FALSE(query.inside({0, 0, 0.005}));
  EXPECT_TRUE(query.inside({0.010, 0, 0.005}));
  EXPECT_FALSE(query.inside({0.010, 0, 0.011}));
  EXPECT_NEAR(query.signed_distance({0.010, 0, 0.001}), -0.001, 1e-15);
}

TEST(SolidQuery, AnswersRightlyNextToDegenerateAndDuplicateTriangles) {
  Mesh mesh = sample::box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(0.01));
  // A T-junction closed by a triangle without area on the edge from corner 0 to corner 1, and a triangle
  // twice.
  mesh.vertices.emplace_back(0.005, 0, 0);
  mesh.triangles.emplace_back(0, 8, 1);
  mesh.triangles.push_back(mesh.triangles.front());
  const SolidQuery query(mesh);
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d point = random_point(random, 0.01);
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.005);
    EXPECT_EQ(query.signed_distance(point + half) < 0, distance_to_box(half, point) < 0);
  }
}

TEST(SolidQuery, RefusesAMeshWithoutSurface) {
  EXPECT_THROW(SolidQuery(Mesh{}), MeshError);
}

}  // namespace
}  // namespace diefill::geometry
