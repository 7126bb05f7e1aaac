// Powder that steps let in: how much of it, and where its grains start.
#include "process/run/powder_source.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/limits/validity_monitor.h"
#include "engine/simulation/simulation.h"
#include "process/powder/material.h"
#include "process/run/check_intervals.h"
#include "process/scene/powder/powder_presets.h"
#include "process/tooling/half_model.h"

namespace diefill::process {
namespace {

constexpr double kRadius = 1.5e-4;   // m, of the spheres
constexpr double kGrainMass = 1e-7;  // kg

/// Powder that a box lets into empty space without gravity.
class Feed {
 public:
  explicit Feed(const PowderInflow& inflow, std::optional<int> mirror = {},
                std::optional<double> period_along_x = {}) {
    scene_.powder = powder_preset("ASC100.29 initial A");
    scene_.powder.grain_mass = kGrainMass;
    scene_.gravity.setZero();
    scene_.pour.rim_speed = 0;
    scene_.numerics.period[0] = period_along_x;
    scene_.steps = {std::make_shared<Inflow>(inflow)};
    tooling_.mirror = mirror;
    std::vector<engine::WallBodySpec> walls;
    if (mirror) walls.push_back(mirror_wall(*mirror));
    simulation_ = std::make_unique<engine::Simulation>(engine_settings(scene_, 1.0), walls);
    schedule_ = std::make_unique<Schedule>(scene_, tooling_, 2 * kRadius);
    source_ = std::make_unique<PowderSource>(scene_, tooling_);
    schedule_->begin(*simulation_);
  }

  /// Steps on, and feeds and checks as a run does, until `over`.
  template <class Over>
  void run_until(const Over& over) {
    while (!over() && simulation_->time() < 0.1) {
      simulation_->step();
      const std::uint64_t step = simulation_->steps();
      if (step % kValidityInterval == 0) monitor_.check(*simulation_);
      if (step % kScheduleInterval == 0) schedule_->update(*simulation_);
      if (step % kFeedInterval != 0) continue;
      // Ids count all grains that ever were, and none leaves.
      const std::size_t before = simulation_->grains().size();
      source_->feed(*simulation_, *schedule_);
      const engine::Grains& grains = simulation_->grains();
      for (std::size_t k = 0; k < grains.size(); ++k)
        if (grains.id[k] >= before) starts_.push_back(grains.position[k]);
    }
  }

  engine::Simulation& simulation() { return *simulation_; }
  const StepState& step() const { return schedule_->of_step(0); }
  /// m, where grains came in.
  const std::vector<Eigen::Vector3d>& starts() const { return starts_; }

 private:
  Scene scene_;
  Tooling tooling_;
  std::unique_ptr<engine::Simulation> simulation_;
  std::unique_ptr<Schedule> schedule_;
  std::unique_ptr<PowderSource> source_;
  engine::ValidityMonitor monitor_;
  std::vector<Eigen::Vector3d> starts_;
};

/// 101.3 grains at 4000 grains a second, falling out of a box about the origin.
PowderInflow fed_at_a_rate() {
  PowderInflow inflow;
  inflow.lower = {-2e-3, -1e-3, -1e-3};
  inflow.upper = {2e-3, 1e-3, 1e-3};
  inflow.velocity = {0, 0, -0.3};
  inflow.mass = 101.3 * kGrainMass;
  inflow.rate = 4000 * kGrainMass;
  return inflow;
}

TEST(PowderSource, AHalfModelGetsTheMassOfBothHalvesAndNoGrainAcrossThePlane) {
  for (const std::optional<int> mirror :
       {std::optional<int>(), std::optional<int>(0), std::optional<int>(1)}) {
    Feed feed(fed_at_a_rate(), mirror);
    ASSERT_NO_THROW(feed.run_until([&] { return feed.step().has_ended(); }));
    const std::size_t copies = mirror ? 2 : 1;
    EXPECT_EQ(copies * feed.starts().size(), 102U);
    EXPECT_EQ(feed.step().grains_fed, feed.starts().size());
    EXPECT_NEAR(feed.step().ended - feed.step().started, 101.3 / 4000, 2.0 / 4000 + 2e-3);
    if (!mirror) continue;
    for (const auto& place : feed.starts()) EXPECT_GE(place[*mirror], kRadius * (1 - 1e-12));
  }
}

TEST(PowderSource, AMassOfWholeGrainsIsInWhenTheyAre) {
  for (const double mass : {3.7e-6, 6.7e-6, 7.4e-6}) {
    const double grains = std::round(mass / kGrainMass);
    ASSERT_LT(grains * kGrainMass, mass) << "by rounding";
    PowderInflow inflow = fed_at_a_rate();
    inflow.rate.reset();
    inflow.mass = mass;
    Feed feed(inflow);
    ASSERT_EQ(feed.simulation().settings().shape().mass, kGrainMass);
    feed.run_until([&] { return feed.step().has_ended(); });
    EXPECT_TRUE(feed.step().has_ended()) << mass;
    EXPECT_EQ(static_cast<double>(feed.starts().size()), grains);
  }
}

TEST(PowderSource, GrainsKeepClearOfThoseAcrossThePeriod) {
  constexpr double kPeriod = 3e-3;  // m
  PowderInflow inflow;
  inflow.lower = {1.2e-3, -1e-3, -1e-3};
  inflow.upper = {1.5e-3, 1e-3, 1e-3};
  inflow.mass = 10 * kGrainMass;
  Feed feed(inflow, {}, kPeriod);
  std::vector<engine::NewGrain> across;
  for (int j = -4; j <= 4; ++j)
    for (int k = -4; k <= 4; ++k) {
      engine::NewGrain grain;
      grain.position = {-1.45e-3, 3.1e-4 * j, 3.1e-4 * k};
      across.push_back(grain);
    }
  feed.simulation().add_grains(across);
  feed.run_until([&] { return !feed.starts().empty(); });
  ASSERT_FALSE(feed.starts().empty());
  for (const auto& start : feed.starts())
    for (const auto& grain : across) {
      Eigen::Vector3d way = start - grain.position;
      way.x() -= kPeriod * std::round(way.x() / kPeriod);
      EXPECT_GE(way.norm(), 2 * kRadius * (1 - 1e-12));
    }
}

}  // namespace
}  // namespace diefill::process
