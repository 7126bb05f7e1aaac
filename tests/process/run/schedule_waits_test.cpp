// Whether a schedule waits for what powder at rest never brings.
#include <gtest/gtest.h>

#include "engine/simulation/simulation.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/machine/actions/settle.h"
#include "process/machine/actions/wait.h"
#include "process/machine/force_control.h"
#include "process/machine/motions/vibration.h"
#include "process/powder/material.h"
#include "process/run/schedule.h"
#include "process/scene/powder/powder_presets.h"

namespace diefill::process {
namespace {

constexpr double kStep = 1e-4;  // s

std::shared_ptr<Step> until(std::shared_ptr<Step> step, const Condition& end) {
  step->plan.until = end;
  return step;
}

Condition for_a_mass() {
  Condition condition;
  condition.filled_mass = 1e-3;
  condition.where = "scene.toml:9:1: step.until";
  return condition;
}

std::shared_ptr<Step> feeding(std::optional<double> rate) {
  PowderInflow inflow;
  inflow.upper = {0.01, 0.01, 0.01};
  inflow.rate = rate;
  return std::make_shared<Inflow>(inflow);
}

std::shared_ptr<Step> shaking() {
  Oscillation oscillation;
  oscillation.amplitude = 1e-3;
  oscillation.frequency = 20;
  oscillation.ramps.ramp = 0.05;
  return std::make_shared<Vibration>(std::vector<std::string>{"die"}, Eigen::Vector3d::UnitX(), oscillation);
}

/// A die of one wall sphere and no powder, which is at rest at once; after `duration` (s) of its steps.
class Waiting {
 public:
  explicit Waiting(std::vector<std::shared_ptr<Step>> steps, double duration = 0.05) {
    scene_.powder = powder_preset("ASC100.29 initial A");
    scene_.steps.assign(steps.begin(), steps.end());
    tooling_.tools.resize(1);
    tooling_.tools[0].spec.name = "die";
    auto settings = engine_settings(scene_, 1.0);
    settings.time_step = kStep;
    engine::WallBodySpec body;
    body.centres = {Eigen::Vector3d::Zero()};
    simulation_ = std::make_unique<engine::Simulation>(settings, std::vector<engine::WallBodySpec>{body});
    schedule_ = std::make_unique<Schedule>(scene_, tooling_, 3e-4);
    schedule_->begin(*simulation_, {});
    go_on(duration);
  }
  void go_on(double duration) {
    for (const double end = simulation_->time() + duration; simulation_->time() < end;) {
      simulation_->step();
      if (simulation_->steps() % 20 == 0) schedule_->update(*simulation_);
    }
  }
  bool for_powder() const { return schedule_->waits_for_powder(*simulation_); }
  std::string unmet() const { return schedule_->unmet_condition(*simulation_); }

 private:
  Scene scene_;
  Tooling tooling_;
  std::unique_ptr<engine::Simulation> simulation_;
  std::unique_ptr<Schedule> schedule_;
};

TEST(ScheduleWaits, ForAMassThatNothingBrings) {
  const Waiting waiting({until(std::make_shared<Settle>(std::nullopt), for_a_mass())});
  EXPECT_TRUE(waiting.for_powder());
  EXPECT_EQ(waiting.unmet(), "scene.toml:9:1: step.until waits for 1 g in the cavity, which holds 0 g");
}

TEST(ScheduleWaits, NotWhereTimeOrAMotionGoesOn) {
  EXPECT_FALSE(Waiting({std::make_shared<Settle>(std::nullopt)}).for_powder());
  EXPECT_FALSE(Waiting({std::make_shared<Wait>(1.0)}).for_powder());
  EXPECT_FALSE(Waiting({until(std::make_shared<Wait>(1.0), for_a_mass())}).for_powder());
  EXPECT_FALSE(Waiting({until(shaking(), for_a_mass())}).for_powder());
  Condition later = for_a_mass();
  later.at = 0.2;
  Waiting waiting({until(std::make_shared<Settle>(std::nullopt), later)});
  EXPECT_FALSE(waiting.for_powder());
  waiting.go_on(0.2);
  EXPECT_TRUE(waiting.for_powder());
}

TEST(ScheduleWaits, NotWherePowderStillComesInSlowly) {
  EXPECT_FALSE(Waiting({until(feeding(1e-9), for_a_mass())}).for_powder());
  EXPECT_TRUE(Waiting({until(feeding(1.0), for_a_mass())}).for_powder())
      << "it lags behind, as there is no room";
  EXPECT_TRUE(Waiting({until(feeding(std::nullopt), for_a_mass())}).for_powder());
}

TEST(ScheduleWaits, ForAStartThatAMassHoldsBack) {
  auto held = std::make_shared<Wait>(1.0);
  held->plan.start = for_a_mass();
  EXPECT_TRUE(Waiting({std::make_shared<Wait>(0.01), held}).for_powder());
  EXPECT_FALSE(Waiting({std::make_shared<Wait>(1.0), held}).for_powder());
}

/// A piston or rotor that presses against nothing, until the powder bears 5 N or 5 N m.
std::shared_ptr<Step> pressing(bool turns, std::vector<double> targets = {5}) {
  ForceControl control;
  control.turns = turns;
  control.axis.direction = -Eigen::Vector3d::UnitZ();
  control.targets = std::move(targets);
  control.pause = 0;
  control.speed_limit = 0.1;
  control.integral_time = 0.02;
  control.travel = turns ? std::numeric_limits<double>::infinity() : 1e-3;
  return std::make_shared<ControlledTool>(std::vector<std::string>{"die"}, control, std::nullopt);
}

TEST(ScheduleWaits, ForAForceThatATravelIsTooShortFor) {
  Waiting waiting({pressing(false)}, 0.01);
  EXPECT_FALSE(waiting.for_powder()) << "it is on its way";
  waiting.go_on(0.04);
  EXPECT_TRUE(waiting.for_powder());
  EXPECT_EQ(waiting.unmet(),
            "die at the end of the way that \"travel\" allows: waits for 5 N, but the powder bears 0 N");
}

TEST(ScheduleWaits, NotWhereARotorTurnsOn) {
  EXPECT_FALSE(Waiting({pressing(true)}, 0.2).for_powder());
}

TEST(ForceControl, IsAtItsLimitWhereItCannotUnloadFurther) {
  ForceControl control;
  control.turns = true;
  control.targets = {0};
  control.pause = 0;
  control.back = 0.1;
  control.travel = std::numeric_limits<double>::infinity();
  ControlState state;
  state.last = 2e-3;
  state.coordinate = -0.05;
  EXPECT_FALSE(control.is_at_its_limit(state));
  state.coordinate = -0.1;
  EXPECT_TRUE(control.is_at_its_limit(state));
  state.last = -1e-3;
  EXPECT_FALSE(control.is_at_its_limit(state)) << "it turns forward again";
  state.passed = 1;
  EXPECT_FALSE(control.is_at_its_limit(state));
}

}  // namespace
}  // namespace diefill::process
