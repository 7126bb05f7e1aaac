// The quaternion scheme of Bierwisch 2009, section 2.2.2, against the printed matrices and free tops.
#include <gtest/gtest.h>

#include "tests/engine/engine_test_support.h"
#include "tests/engine/thesis_rotation.h"

namespace diefill::engine {
namespace {

TEST(RigidMotion, ThesisIdentityQuaternionDoesNotTurn) {
  const ThesisQuaternion identity(0, 0, 0, 1);
  EXPECT_LT((rotation_matrix(from_thesis(identity)) - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_LT((thesis_matrix(identity) - Eigen::Matrix3d::Identity()).norm(), 1e-14);
}

TEST(RigidMotion, RotationMatrixIsTransposeOfThesisMatrix) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 100; ++k) {
    const Quaternion q = random_orientation(random);
    EXPECT_LT((rotation_matrix(q).transpose() - thesis_matrix(to_thesis(q))).norm(), 1e-14);
  }
}

TEST(RigidMotion, RateIsThatOfThesisMatrix) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 100; ++k) {
    const Quaternion q = random_orientation(random);
    const Eigen::Vector3d spin = random_vector(random, 100);
    const ThesisQuaternion printed = 0.5 * thesis_rate_matrix(to_thesis(q)) * spin;
    EXPECT_LT((quaternion_rate(q, spin) - from_thesis(printed)).norm(), 1e-13 * spin.norm());
  }
}

TEST(RigidMotion, RateMatrixHasEvansMuradIdentities) {
  std::mt19937_64 random(3);
  for (int k = 0; k < 100; ++k) {
    const ThesisQuaternion q = to_thesis(random_orientation(random));
    const auto rate = thesis_rate_matrix(q);
    EXPECT_LT((rate.transpose() * rate - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_LT((rate.transpose() * q).norm(), 1e-14);
    EXPECT_LT((rate * rate.transpose() - (Eigen::Matrix4d::Identity() - q * q.transpose())).norm(), 1e-14);
  }
}

TEST(RigidMotion, MatrixTurnsWithBodySpin) {
  // dA/dt = -[Omega]x A, by a central difference along dq/dt.
  std::mt19937_64 random(4);
  const Quaternion q = random_orientation(random);
  const Eigen::Vector3d spin(3, -2, 5);
  const double step = 1e-6;
  const Quaternion rate = quaternion_rate(q, spin);
  const Eigen::Matrix3d difference =
      (thesis_matrix(to_thesis(q + step * rate)) - thesis_matrix(to_thesis(q - step * rate))) / (2 * step);
  Eigen::Matrix3d cross;
  cross << 0, -spin[2], spin[1], spin[2], 0, -spin[0], -spin[1], spin[0], 0;
  EXPECT_LT((difference + cross * thesis_matrix(to_thesis(q))).norm(), 1e-8);
}

TEST(RigidMotion, TurnAboutZIsWhatTheThesisSays) {
  const double angle = 1e-3;
  const ThesisQuaternion q(0, 0, std::sin(0.5 * angle), std::cos(0.5 * angle));
  const Eigen::Vector3d body_x_in_lab = rotation_matrix(from_thesis(q)).col(0);
  EXPECT_NEAR(body_x_in_lab.x(), std::cos(angle), 1e-15);
  EXPECT_NEAR(body_x_in_lab.y(), std::sin(angle), 1e-15);
}

TEST(RigidMotion, StepKeepsTheNorm) {
  std::mt19937_64 random(5);
  double worst = 0;
  for (int k = 0; k < 10000; ++k) {
    const Quaternion q = random_orientation(random);
    const Quaternion next =
        advance_orientation(q, random_vector(random, 1e4), random_vector(random, 1e8), 1e-5);
    worst = std::max(worst, std::abs(next.squaredNorm() - 1));
  }
  EXPECT_LT(worst, 1e-14);
}

TEST(RigidMotion, StepIsSecondOrderInTime) {
  // Constant spin about a skew axis: the exact quaternion is known.
  const Quaternion start = Quaternion(0.3, -0.5, 0.7, 0.2).normalized();
  const Eigen::Vector3d spin(40, -70, 20);
  const double duration = 0.05;
  const auto error = [&](int steps) {
    Quaternion q = start;
    for (int k = 0; k < steps; ++k)
      q = advance_orientation(q, spin, Eigen::Vector3d::Zero(), duration / steps);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(spin.norm() * duration, spin.normalized()));
    const Eigen::Quaterniond exact = Eigen::Quaterniond(start[0], start[1], start[2], start[3]) * turn;
    return (q - Quaternion(exact.w(), exact.x(), exact.y(), exact.z())).norm();
  };
  EXPECT_NEAR(std::log2(error(200) / error(400)), 2, 0.1);
}

}  // namespace
}  // namespace diefill::engine
