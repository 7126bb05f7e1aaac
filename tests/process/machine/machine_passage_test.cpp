// Motion of a shoe passage: closed forms against numerical integration, and travel from the boxes of cavity
// and tool.
#include <gtest/gtest.h>

#include <cmath>

#include "process/input/scene_error.h"
#include "process/machine/motions/passage.h"

namespace diefill::process {
namespace {

struct Move {
  double distance, velocity, acceleration;
};

class StraightMoves : public testing::TestWithParam<Move> {};

TEST_P(StraightMoves, PositionIsTheIntegralOfVelocity) {
  const Move& given = GetParam();
  const StraightMove move(given.distance, given.velocity, given.acceleration);
  const int steps = 200000;
  const double interval = move.duration() / steps;
  double position = 0;
  for (int i = 0; i < steps; ++i) {
    position += interval * move.velocity((i + 0.5) * interval);
    ASSERT_NEAR(position, move.position((i + 1) * interval), 1e-8 * given.distance) << "after interval " << i;
  }
}

TEST_P(StraightMoves, StartAndEndAtRestAtTheRightPlaces) {
  const Move& given = GetParam();
  const StraightMove move(given.distance, given.velocity, given.acceleration);
  EXPECT_EQ(move.position(0), 0);
  EXPECT_EQ(move.velocity(0), 0);
  EXPECT_EQ(move.position(move.duration()), given.distance);
  EXPECT_EQ(move.velocity(move.duration()), 0);
  EXPECT_EQ(move.position(-1), 0);
  EXPECT_EQ(move.position(move.duration() + 1), given.distance);
  EXPECT_EQ(move.velocity(move.duration() + 1), 0);
}

TEST_P(StraightMoves, KeepVelocityContinuousWithinTheAcceleration) {
  const Move& given = GetParam();
  const StraightMove move(given.distance, given.velocity, given.acceleration);
  const int steps = 10000;
  const double interval = move.duration() / steps;
  double fastest = 0;
  for (int i = -1; i <= steps; ++i) {
    const double change = move.velocity((i + 1) * interval) - move.velocity(i * interval);
    EXPECT_LE(std::abs(change), given.acceleration * interval * (1 + 1e-9) + 1e-15);
    fastest = std::max(fastest, move.velocity(i * interval));
  }
  EXPECT_LE(fastest, given.velocity);
}

INSTANTIATE_TEST_SUITE_P(Machine, StraightMoves,
                         testing::Values(Move{0.07, 0.2, 10}, Move{0.07, 0.09, 10}, Move{0.07, 0.5, 10},
                                         Move{0.001, 0.2, 10},  // too short to reach 0.2 m/s
                                         Move{0.004, 0.2, 10},  // just reaches it
                                         Move{0.3, 0.022, 0.1}));

TEST(StraightMove, TakesDistanceOverVelocityPlusOneRamp) {
  EXPECT_DOUBLE_EQ(StraightMove(0.07, 0.2, 10).duration(), 0.07 / 0.2 + 0.2 / 10);
  // Too short: half the way in sqrt(distance / acceleration), and the same again.
  EXPECT_DOUBLE_EQ(StraightMove(0.001, 0.2, 10).duration(), 2 * std::sqrt(0.001 / 10));
}

TEST(StraightMove, RefusesWhatIsNotPositive) {
  EXPECT_THROW(StraightMove(0, 1, 1), std::invalid_argument);
  EXPECT_THROW(StraightMove(1, -1, 1), std::invalid_argument);
  EXPECT_THROW(StraightMove(1, 1, std::nan("")), std::invalid_argument);
}

PassageSpec narrow_ring() {
  PassageSpec spec;
  spec.tool = "shoe";
  spec.where = "fill.toml:30:1: step.travel";
  return spec;
}

/// The ring of 4.462 mm and the shoe of 32 x 29 mm inside with walls of 3 mm, standing at x = 35.4 mm.
MachineContext narrow_ring_boxes() {
  MachineContext context;
  context.cavity_lower = {-12.462e-3, -12.462e-3, -20e-3};
  context.cavity_upper = {12.462e-3, 12.462e-3, 0};
  context.tool_lower = {(35.4 - 19) * 1e-3, -17.5e-3, 0};
  context.tool_upper = {(35.4 + 19) * 1e-3, 17.5e-3, 46e-3};
  return context;
}

TEST(Passage, CarriesTheWholeToolBeyondTheCavityByTheClearance) {
  const auto prepared = Passage(narrow_ring()).prepared(narrow_ring_boxes());
  ASSERT_TRUE(prepared);
  const Step& passage = *prepared;
  const ToolMotion end = passage.motion(*passage.duration());
  // The trailing side, at x = 54.4 mm, must come to rest 2 mm beyond -12.462 mm.
  EXPECT_NEAR(54.4e-3 + end.translation.x(), -14.462e-3, 1e-15);
  EXPECT_EQ(end.translation.y(), 0);
  EXPECT_EQ(end.translation.z(), 0);
  EXPECT_EQ(end.velocity.norm(), 0);
  const double travel = 54.4e-3 + 14.462e-3;
  EXPECT_NEAR(*passage.duration(), travel / 0.2 + 0.2 / 10, 1e-12);
}

TEST(Passage, RunsInEveryDirectionByTheSameRule) {
  const struct {
    Eigen::Vector3d direction;
    double shoe_x, shoe_y;
  } cases[] = {{Eigen::Vector3d::UnitX(), -0.04, 0},
               {-Eigen::Vector3d::UnitY(), 0, 0.04},
               {Eigen::Vector3d::UnitY(), 0, -0.04}};
  for (const auto& given : cases) {
    PassageSpec spec = narrow_ring();
    spec.direction = given.direction;
    MachineContext context = narrow_ring_boxes();
    context.tool_lower = {given.shoe_x - 0.019, given.shoe_y - 0.019, 0};
    context.tool_upper = {given.shoe_x + 0.019, given.shoe_y + 0.019, 0.046};
    const auto prepared = Passage(spec).prepared(context);
    ASSERT_TRUE(prepared);
    const Step& passage = *prepared;
    const Eigen::Vector3d travelled = passage.motion(*passage.duration()).translation;
    EXPECT_TRUE(travelled.isApprox((0.04 + 0.019 + 0.012462 + 0.002) * given.direction, 1e-12))
        << travelled.transpose();
  }
}

TEST(Passage, RunsAcrossTheAxesToo) {
  PassageSpec spec = narrow_ring();
  spec.direction = Eigen::Vector3d(1, 1, 0).normalized();
  MachineContext context = narrow_ring_boxes();
  context.tool_lower = {-0.04 - 0.019, -0.04 - 0.019, 0};
  context.tool_upper = {-0.04 + 0.019, -0.04 + 0.019, 0.046};
  const auto prepared = Passage(spec).prepared(context);
  ASSERT_TRUE(prepared);
  const Step& passage = *prepared;
  // From corner to corner of both boxes, and the clearance.
  const double travel = std::sqrt(2) * (0.04 + 0.019 + 0.012462) + 0.002;
  EXPECT_TRUE(passage.motion(*passage.duration()).translation.isApprox(travel * spec.direction, 1e-12));
}

TEST(Passage, ReachesItsVelocityBeforeTheCavity) {
  const auto prepared = Passage(narrow_ring()).prepared(narrow_ring_boxes());
  ASSERT_TRUE(prepared);
  const Step& passage = *prepared;
  // The inside of the leading wall stands 6.938 mm before the ring; 2 mm are needed to accelerate.
  EXPECT_DOUBLE_EQ(passage.motion(0.021).velocity.x(), -0.2);
  EXPECT_GT(passage.motion(0.021).translation.x(), -6.938e-3);
}

TEST(Passage, ReturnsToTheStartAfterAnEvenNumber) {
  PassageSpec spec = narrow_ring();
  spec.passages = 6;
  spec.travel = 0.068;
  const Passage passage(spec);
  const double one = 0.068 / 0.2 + 0.02;
  EXPECT_NEAR(*passage.duration(), 6 * one + 5 * 0.05, 1e-12);
  EXPECT_NEAR(passage.motion(*passage.duration()).translation.norm(), 0, 1e-15);
  EXPECT_NEAR(passage.motion(*passage.duration() + 10).translation.norm(), 0, 1e-15);
  EXPECT_EQ(passage.description(), "6 passages at 0.2 m/s");
}

TEST(Passage, RestsBetweenCrossingsAndThenGoesBack) {
  PassageSpec spec = narrow_ring();
  spec.passages = 2;
  spec.travel = 0.068;
  const Passage passage(spec);
  const double one = 0.068 / 0.2 + 0.02;
  for (const double into_pause : {0.0, 0.025, 0.0499}) {
    EXPECT_DOUBLE_EQ(passage.motion(one + into_pause).translation.x(), -0.068);
    EXPECT_NEAR(passage.motion(one + into_pause).velocity.norm(), 0, 1e-12);
  }
  EXPECT_DOUBLE_EQ(passage.motion(one + 0.05 + one / 2).translation.x(), -0.034);
  EXPECT_DOUBLE_EQ(passage.motion(one + 0.05 + one / 2).velocity.x(), 0.2);
}

TEST(Passage, TranslationIsTheIntegralOfVelocityOverAllCrossings) {
  PassageSpec spec = narrow_ring();
  spec.passages = 3;
  spec.travel = 0.03;
  const Passage passage(spec);
  const int steps = 300000;
  const double interval = *passage.duration() / steps;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  for (int i = 0; i < steps; ++i) {
    position += interval * passage.motion((i + 0.5) * interval).velocity;
    ASSERT_NEAR((position - passage.motion((i + 1) * interval).translation).norm(), 0, 1e-8);
  }
}

TEST(Passage, WithoutPauseDoesNotJump) {
  PassageSpec spec = narrow_ring();
  spec.passages = 2;
  spec.pause = 0;
  spec.travel = 0.03;
  const Passage passage(spec);
  const double turn = *passage.duration() / 2;
  EXPECT_NEAR(passage.motion(turn - 1e-9).translation.x(), -0.03, 1e-12);
  EXPECT_NEAR(passage.motion(turn + 1e-9).translation.x(), -0.03, 1e-12);
}

std::string complaint(PassageSpec spec, const MachineContext& context) {
  try {
    Passage(std::move(spec)).prepared(context);
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

TEST(Passage, AsksForTheTravelWhenThereIsNoCavity) {
  MachineContext context = narrow_ring_boxes();
  context.cavity_lower = context.cavity_upper = Eigen::Vector3d::Zero();
  const std::string message = complaint(narrow_ring(), context);
  EXPECT_NE(message.find("fill.toml:30:1: step.travel: found no cavity"), std::string::npos) << message;
  EXPECT_NE(message.find("travel = \"60 mm\""), std::string::npos) << message;
}

TEST(Passage, RefusesToStartBeyondTheCavity) {
  PassageSpec spec = narrow_ring();
  spec.direction = Eigen::Vector3d::UnitX();
  const std::string message = complaint(spec, narrow_ring_boxes());
  EXPECT_NE(message.find("found \"shoe\" already beyond the cavity (3.938 mm past it"), std::string::npos)
      << message;
  EXPECT_NE(message.find("reverse direction"), std::string::npos) << message;
}

TEST(Passage, HasNoMotionBeforeItIsPrepared) {
  const Passage passage(narrow_ring());
  EXPECT_THROW(passage.motion(0), std::logic_error);
  EXPECT_THROW(passage.duration(), std::logic_error);
}

}  // namespace
}  // namespace diefill::process
