// When steps begin and end: in turn, together, by time and by conditions, each once, and the same after a
// restart in the middle.
#include "process/run/schedule.h"

#include <gtest/gtest.h>

#include <map>

#include "engine/simulation/simulation.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/machine/actions/settle.h"
#include "process/machine/actions/wait.h"
#include "process/machine/motions/move.h"
#include "process/machine/motions/vibration.h"
#include "process/powder/material.h"
#include "process/run/snapshots.h"
#include "process/scene/powder/powder_presets.h"

namespace diefill::process {
namespace {

constexpr double kStep = 1e-4;                // s
constexpr double kUpdate = 20 * kStep;        // s, between two looks at the schedule
constexpr double kTolerance = 2.5 * kUpdate;  // s, of a step's start and end

std::shared_ptr<Step> named(std::shared_ptr<Step> step, const std::string& name) {
  step->plan.name = name;
  return step;
}

std::shared_ptr<Step> starting(std::shared_ptr<Step> step, const Condition& start) {
  step->plan.start = start;
  return step;
}

std::shared_ptr<Step> until(std::shared_ptr<Step> step, const Condition& end) {
  step->plan.until = end;
  return step;
}

std::shared_ptr<Step> wait(double duration) {
  return std::make_shared<Wait>(duration);
}

std::shared_ptr<Step> shaking_shoe() {
  Oscillation oscillation;
  oscillation.amplitude = 1e-3;
  oscillation.frequency = 20;
  oscillation.ramps.ramp = 0.05;
  return std::make_shared<Vibration>(std::vector<std::string>{"shoe"}, Eigen::Vector3d::UnitX(), oscillation);
}

std::shared_ptr<Step> lowering(double distance) {
  MoveSpec spec;
  spec.tools = {"shoe"};
  spec.stations = {distance};
  spec.velocity = 0.1;
  return std::make_shared<Move>(spec);
}

Condition after(const std::string& name, double delay = 0) {
  Condition condition;
  condition.after = name;
  condition.delay = delay;
  return condition;
}

Condition together_with(const std::string& name) {
  Condition condition;
  condition.with = name;
  return condition;
}

Condition at(double time) {
  Condition condition;
  condition.at = time;
  return condition;
}

/// A die and a shoe of one wall sphere each and no powder, which is at rest at once.
class Machine {
 public:
  explicit Machine(std::vector<std::shared_ptr<Step>> steps, const ScheduleState& state = {}) {
    scene_.powder = powder_preset("ASC100.29 initial A");
    scene_.steps.assign(steps.begin(), steps.end());
    tooling_.tools.resize(2);
    tooling_.tools[0].spec.name = "die";
    tooling_.tools[1].spec.name = "shoe";
    auto settings = engine_settings(scene_, 1.0);
    settings.time_step = kStep;
    std::vector<engine::WallBodySpec> bodies(2);
    for (auto& body : bodies) body.centres = {Eigen::Vector3d::Zero()};
    simulation_ = std::make_unique<engine::Simulation>(settings, bodies);
    schedule_ = std::make_unique<Schedule>(scene_, tooling_, 3e-4);
    schedule_->begin(*simulation_, state);
  }

  /// Runs for `duration` s or to the end.
  void run(double duration) {
    const double end = simulation_->time() + duration;
    while (!schedule_->finished() && simulation_->time() < end - 0.5 * kStep) {
      simulation_->step();
      schedule_->observe(*simulation_);
      if (simulation_->steps() % 20 == 0) schedule_->update(*simulation_);
    }
  }

  const StepState& step(std::size_t k) const { return schedule_->of_step(k); }
  Schedule& schedule() { return *schedule_; }
  engine::Simulation& simulation() { return *simulation_; }
  const Scene& scene() const { return scene_; }

 private:
  Scene scene_;
  Tooling tooling_;
  std::unique_ptr<engine::Simulation> simulation_;
  std::unique_ptr<Schedule> schedule_;
};

TEST(Schedule, GoesFromStepToStepUnlessToldOtherwise) {
  Machine machine({wait(0.1), lowering(0.01), wait(0.05)});
  machine.run(10);
  ASSERT_TRUE(machine.schedule().finished());
  EXPECT_EQ(machine.step(1).started, machine.step(0).ended);
  EXPECT_EQ(machine.step(2).started, machine.step(1).ended);
  EXPECT_NEAR(machine.step(0).ended - machine.step(0).started, 0.1, kUpdate);
  EXPECT_NEAR(machine.step(1).ended - machine.step(1).started, 0.01 / 0.1 + 0.01, kUpdate);
  EXPECT_NEAR(machine.simulation().body_motion(1).translation.z(), -0.01, 1e-15);
  EXPECT_EQ(machine.simulation().body_motion(1).velocity.norm(), 0);
}

TEST(Schedule, StartsStepsByTimeByOthersAndTogether) {
  Machine machine({named(wait(0.1), "first"), starting(wait(0.02), at(0.3)),
                   starting(lowering(0.01), together_with("first")),
                   starting(wait(0.02), after("first", 0.05)),
                   until(starting(shaking_shoe(), together_with("first")), after("first"))});
  machine.run(10);
  ASSERT_TRUE(machine.schedule().finished());
  const double begin = machine.step(0).started;
  EXPECT_NEAR(machine.step(1).started - begin, 0.3, kTolerance);
  EXPECT_EQ(machine.step(2).started, begin);
  EXPECT_NEAR(machine.step(3).started, machine.step(0).ended + 0.05, kTolerance);
  EXPECT_NEAR(machine.step(4).stop_requested, machine.step(0).ended, kTolerance);
  EXPECT_NEAR(machine.step(4).ended - machine.step(4).stop_requested, 0.05, kTolerance);  // dying away
  // Shaken no more, where the other motion has put it.
  EXPECT_TRUE(machine.simulation().body_motion(1).translation.isApprox(Eigen::Vector3d(0, 0, -0.01), 1e-12));
}

TEST(Schedule, WaitsForRestMassAndForce) {
  Condition full;
  full.filled_mass = 1e-3;
  Condition pressed;
  pressed.force = 1;
  pressed.on = "shoe";
  Condition rest;
  rest.at_rest = true;
  rest.limits = RestLimits{1e-3, 0.02};
  Machine machine({starting(wait(0.1), rest), starting(wait(0.1), full), starting(wait(0.1), pressed)});
  machine.run(0.5);
  EXPECT_TRUE(machine.step(0).has_ended());
  EXPECT_TRUE(machine.step(1).is_pending());  // there is no powder
  EXPECT_TRUE(machine.step(2).is_pending());
  EXPECT_FALSE(machine.schedule().finished());
}

TEST(Schedule, GoesOnInTheMiddleAsIfItHadNeverStopped) {
  const auto steps = [] {
    return std::vector<std::shared_ptr<Step>>{
        named(wait(0.1), "first"), starting(lowering(0.01), together_with("first")),
        until(starting(shaking_shoe(), together_with("first")), after("first")), wait(0.05)};
  };
  Machine unbroken(steps());
  unbroken.run(10);
  for (const double moment : {0.0005, 0.03, 0.0985, 0.1251, 0.18}) {
    Machine broken(steps());
    broken.run(moment);
    const ScheduleState kept = broken.schedule().state();
    Machine resumed(steps(), kept);
    resumed.simulation().restore(broken.simulation().snapshot());
    resumed.run(0.002);
    broken.run(0.002);
    EXPECT_EQ(resumed.simulation().body_motion(1).translation,
              broken.simulation().body_motion(1).translation);
    EXPECT_EQ(resumed.simulation().body_motion(1).velocity, broken.simulation().body_motion(1).velocity);
    resumed.run(10);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_EQ(resumed.step(k).started, unbroken.step(k).started) << moment << ", step " << k;
      EXPECT_EQ(resumed.step(k).stop_requested, unbroken.step(k).stop_requested) << moment << ", step " << k;
      EXPECT_EQ(resumed.step(k).ended, unbroken.step(k).ended) << moment << ", step " << k;
    }
  }
}

TEST(Schedule, ForeseesStartsAndEnds) {
  Scene scene;
  scene.steps = {named(wait(0.1), "first"), starting(lowering(0.01), at(0.3)),
                 until(starting(shaking_shoe(), together_with("first")), after("first"))};
  const Stages stages(scene);
  const auto plan = predicted(stages, 0.25);
  EXPECT_NEAR(plan[1].started, 0.25, 1e-12);
  EXPECT_NEAR(plan[2].started, 0.55, 1e-12);
  EXPECT_NEAR(plan[3].stop_requested, 0.35, 1e-12);
  EXPECT_NEAR(plan[3].ended, 0.4, 1e-12);
  EXPECT_NEAR(plan[4].started, plan[2].ended, 1e-12);  // the settling added at the end waits for all
  EXPECT_FALSE(stages.stays("shoe"));
  EXPECT_TRUE(stages.stays("die"));
}

TEST(Schedule, ForeseesHowLongPowderIsFed) {
  PowderInflow inflow;
  inflow.mass = 33.165e-3;
  inflow.rate = 3.3165e-3;
  Scene scene;
  scene.steps = {std::make_shared<Inflow>(inflow), wait(0.1)};
  const auto plan = predicted(Stages(scene), 0.25);
  EXPECT_NEAR(plan[1].ended - plan[1].started, 10, 1e-9);
  EXPECT_NEAR(plan[2].started, plan[1].ended, 1e-12);
  // As room becomes free: how long that takes is not known.
  inflow.rate.reset();
  scene.steps = {std::make_shared<Inflow>(inflow)};
  const auto unknown = predicted(Stages(scene), 0.25);
  EXPECT_NEAR(unknown[1].ended - unknown[1].started, 0.25, 1e-12);
}

TEST(Schedule, ForeseesTheEarlierOfAMassAndACondition) {
  PowderInflow inflow;
  inflow.mass = 10e-3;
  inflow.rate = 10e-3;  // 1 s
  const auto lasts = [&](const Condition& condition) {
    Scene scene;
    scene.steps = {until(std::make_shared<Inflow>(inflow), condition), named(wait(0.1), "next")};
    const auto plan = predicted(Stages(scene), 0.25);
    EXPECT_NEAR(plan[2].started, plan[1].ended, 1e-12);
    return plan[1].ended - plan[1].started;
  };
  EXPECT_NEAR(lasts(at(0.4)), 0.4, 1e-12);
  EXPECT_NEAR(lasts(at(3)), 1, 1e-12);
  Condition full = at(0.4);
  full.filled_mass = 5e-3;
  EXPECT_NEAR(lasts(full), 0.65, 1e-12);
  inflow.rate.reset();
  EXPECT_NEAR(lasts(at(0.1)), 0.1, 1e-12);
  EXPECT_NEAR(lasts(at(0.4)), 0.25, 1e-12);
}

TEST(Snapshots, AreTakenOnceOrAgainAndAgainAndSurviveARestart) {
  Machine machine({named(wait(0.1), "first"), wait(0.1)});
  Scene scene;
  scene.snapshots.resize(2);
  scene.snapshots[0].name = "filled";
  scene.snapshots[0].when = after("first");
  scene.snapshots[1].name = "all along";
  scene.snapshots[1].every = 0.05;
  Snapshots snapshots(scene);
  std::map<std::string, double> taken;
  while (!machine.schedule().finished()) {
    machine.run(kUpdate);
    const double now = machine.simulation().time();
    for (const auto& name : snapshots.due(machine.schedule(), machine.simulation())) {
      EXPECT_FALSE(taken.contains(name)) << name;
      taken[name] = now;
    }
    Snapshots restarted(scene);
    restarted.restore(snapshots.state());
    EXPECT_TRUE(restarted.due(machine.schedule(), machine.simulation()).empty());
  }
  ASSERT_TRUE(taken.contains("filled"));
  EXPECT_NEAR(taken["filled"], machine.step(0).ended, kUpdate);
  ASSERT_TRUE(taken.contains("all along 0004"));
  EXPECT_NEAR(taken["all along 0004"] - taken["all along 0001"], 0.15, kTolerance);
}

TEST(Snapshots, AreAllToComeUntilTheFirstCounts) {
  Machine machine({named(wait(0.1), "first"), wait(0.1)});
  Scene scene;
  scene.snapshots.resize(2);
  scene.snapshots[0].when = after("first", 0.03);
  scene.snapshots[1].when = after("first");
  scene.snapshots[1].when->at_rest = true;
  const Snapshots both(scene);
  const auto none_due_before = [&](const Snapshots& snapshots) {
    return snapshots.none_due_before(machine.schedule().stages(), machine.schedule().state().steps,
                                     machine.simulation().time());
  };
  EXPECT_TRUE(none_due_before(both)) << "before the powder rests";
  while (!machine.step(0).has_ended()) {
    machine.run(kUpdate);
    EXPECT_TRUE(none_due_before(both)) << machine.simulation().time();
  }
  machine.run(kUpdate);
  EXPECT_FALSE(none_due_before(both)) << "one waits for rest since the first step is over";
  scene.snapshots.pop_back();
  const Snapshots delayed(scene);
  EXPECT_TRUE(none_due_before(delayed));
  machine.run(0.03);
  EXPECT_FALSE(none_due_before(delayed));
}

}  // namespace
}  // namespace diefill::process
