// A result as it stood earlier, where the die moved in between.
#include "process/measure/earlier_instant.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "tests/process/measure_sample.h"

namespace diefill::process {
namespace {

/// A block of grains and a die that was turned by 90 degrees about z and 30 mm higher, with the powder in it.
results::FillResult moved_die() {
  results::FillResult result;
  result.powder = powder_of(block(3, kDiameter));
  result.powder.time = 2;
  results::ToolState die;
  die.name = die.role = "die";
  die.vertices = {{0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}};
  die.triangles = {{0, 1, 2}};
  result.tools = {die};
  results::Instant instant;
  instant.time = 1;
  instant.id = result.powder.id;
  instant.orientation = result.powder.orientation;
  instant.velocity.assign(result.powder.position.size(), Eigen::Vector3d(1, 0, 0));
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()));
  const Eigen::Vector3d rise(0, 0, 0.03);
  for (const auto& place : result.powder.position) instant.position.emplace_back(turn * place + rise);
  instant.tool_orientation = {{turn.w(), turn.x(), turn.y(), turn.z()}};
  instant.tool_displacement = {rise};
  result.instants = {instant};
  return result;
}

TEST(EarlierInstant, IsMeasuredInTheFrameOfTheDieAsItWasThen) {
  const results::FillResult result = moved_die();
  const auto then = result_at(result, 1, false);
  ASSERT_EQ(then.powder.position.size(), result.powder.position.size());
  for (std::size_t k = 0; k < then.powder.position.size(); ++k) {
    EXPECT_LT((then.powder.position[k] - result.powder.position[k]).norm(), 1e-15);
    EXPECT_LT((then.powder.velocity[k] - Eigen::Vector3d(0, -1, 0)).norm(), 1e-15);
  }
  EXPECT_LT((then.tools[0].vertices[0] - result.tools[0].vertices[0]).norm(), 1e-15);
}

TEST(EarlierInstant, OfAFilmIsInTheFrameThatItWasKeptIn) {
  const results::FillResult result = moved_die();
  const auto then = film_frame_at(result, 1, false);
  EXPECT_EQ(then.powder.position, result.instants[0].position);
  EXPECT_LT((then.tools[0].vertices[0] - Eigen::Vector3d(0, 0.01, 0.03)).norm(), 1e-15);
}

TEST(EarlierInstant, WithoutADieStaysInTheLaboratoryFrame) {
  results::FillResult result = moved_die();
  result.tools[0].role = "plate";
  EXPECT_EQ(result_at(result, 1, false).powder.position, result.instants[0].position);
}

}  // namespace
}  // namespace diefill::process
