// The parts a run is made of: tool poses, walls of periodic scenes, the poured lattice, rest, checkpoints.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "engine/simulation/simulation.h"
#include "geometry/solid/solid_query.h"
#include "process/powder/material.h"
#include "process/powder/powder_mixture.h"
#include "process/results/storage/result_file.h"
#include "process/run/restart/checkpoint.h"
#include "process/run/suction.h"
#include "process/scene/powder/powder_presets.h"
#include "process/setup/pour.h"
#include "process/tooling/periodic_tool.h"
#include "process/tooling/rest.h"
#include "tests/support/temporary_folder.h"

namespace diefill::process {
namespace {

TEST(Permeability, IsThatOfKozenyAndCarman) {
  // Spheres of 0.1 mm at solid fraction 0.4: 0.216e-8 / 28.8 m^2.
  EXPECT_NEAR(permeability(1e-4, 0.4), 7.5e-11, 1e-14);
  EXPECT_NEAR(permeability(2e-4, 0.4) / permeability(1e-4, 0.4), 4, 1e-12);
}

TEST(Suction, PullsByTheFallOfPressureAndRefusesPowderTooFineForTheStep) {
  Scene scene;
  scene.powder = powder_preset("ASC100.29 D2");
  scene.suction = SuctionSpec{.tool = "punch", .particle_diameter = 1e-4, .solid_fraction = 0.4};
  Tooling tooling;
  tooling.cavity.found = true;
  tooling.cavity.box.include(Eigen::Vector3d::Zero());
  tooling.tools.emplace_back().spec.name = "punch";
  const auto settings = engine_settings(scene, 1.0);
  const auto flow = air_flow_of(scene, tooling, settings);
  // 1.8e-5 Pa s over 7.5e-11 m^2, times the volume that a grain stands for.
  ASSERT_EQ(flow->resistance.size(), 1U);
  EXPECT_NEAR(flow->resistance[0], 2.4e5 * settings.shape().solid_volume / 0.4, 1e-9 * flow->resistance[0]);
  scene.suction->particle_diameter = 1e-6;
  EXPECT_THROW(air_flow_of(scene, tooling, settings), SceneError);
  scene.suction->particle_diameter = 1e-4;
  tooling.cavity.found = false;
  EXPECT_THROW(air_flow_of(scene, tooling, settings), SceneError);
}

TEST(ClumpPose, TurnsAboutThePivotAndCarriesEarlierShifts) {
  ToolMotion quarter;
  quarter.rotation = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  quarter.pivot = {1, 0, 0};
  quarter.angular_velocity = {0, 0, 2};
  ToolPose before;
  before.translation = {1, 0, 0};  // the body's origin now stands on the pivot
  const ToolPose pose = compose(quarter, before);
  EXPECT_NEAR((pose.translation - Eigen::Vector3d(1, 0, 0)).norm(), 0, 1e-15);
  // A point one metre along x in the body goes round to one metre along y from the pivot, moving along -x.
  const Eigen::Vector3d point = pose.rotation * Eigen::Vector3d::UnitX() + pose.translation;
  EXPECT_NEAR((point - Eigen::Vector3d(1, 1, 0)).norm(), 0, 1e-15);
  const Eigen::Vector3d velocity = pose.velocity + pose.angular_velocity.cross(point - pose.translation);
  EXPECT_NEAR((velocity - Eigen::Vector3d(-2, 0, 0)).norm(), 0, 1e-15);
}

geometry::Mesh box(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  geometry::Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.emplace_back(corner & 1 ? upper[0] : lower[0], corner & 2 ? upper[1] : lower[1],
                               corner & 4 ? upper[2] : lower[2]);
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

TEST(PeriodicWall, RepeatsExactlyWithThePeriodAndHasNoSeam) {
  const double period = 2.16e-3;
  geometry::WallSphereOptions options;
  const auto spheres = make_periodic_wall_spheres(box({-2e-3, -5e-3, -2e-3}, {2e-3, 5e-3, 0}), options,
                                                  {{std::nullopt, period, std::nullopt}}, period, "plate");
  std::set<std::pair<long, long>> rows;
  for (const auto& centre : spheres.centres) {
    if (centre[2] < -1.6e-4) continue;  // the top only
    EXPECT_NEAR(centre[2], -options.radius, 1e-12);
    rows.insert({std::lround(centre[0] * 1e9), std::lround(centre[1] * 1e9)});
  }
  ASSERT_GT(rows.size(), 100U);
  const long shift = std::lround(period * 1e9);
  for (const auto& [x, y] : rows) {
    if (std::abs(static_cast<double>(y) + 1) > 0.5e9 * period)
      continue;  // one border row is the copy of the other
    const auto copies =
        rows.count({x, y + shift}) + rows.count({x, y + shift + 1}) + rows.count({x, y + shift - 1});
    EXPECT_GE(copies, 1U) << x << " " << y;
  }
}

constexpr double kGrain = 1e-3;  // m, clearance of tools from the borders of a period

/// A period of 2 mm along y.
PeriodicPath short_period() {
  return {.period = {std::nullopt, 2e-3, std::nullopt}, .clearance = 2e-4};
}

geometry::Mesh plate() {
  return box({-2e-3, -5e-3, -2e-3}, {2e-3, 5e-3, 0});
}

TEST(PeriodicWall, RefusesAToolThatEndsAtTheBorderOrDiffersBetweenItsEnds) {
  const geometry::WallSphereOptions options;
  const PeriodicPath path{.period = {std::nullopt, 4e-3, std::nullopt}, .clearance = kGrain};
  EXPECT_THROW(make_periodic_wall_spheres(box({-2e-3, -1.5e-3, -2e-3}, {2e-3, 1.5e-3, 0}), options, path,
                                          1e-3, "plate"),
               SceneError);
  auto wedge = plate();
  wedge.vertices[7][1] = 2e-3;
  EXPECT_THROW(make_periodic_wall_spheres(wedge, options, short_period(), 1e-3, "plate"), SceneError);
  auto tilted = plate();
  tilted.vertices[6][2] = tilted.vertices[7][2] = 1e-3;
  EXPECT_THROW(make_periodic_wall_spheres(tilted, options, short_period(), 1e-3, "plate"), SceneError);
}

TEST(PeriodicWall, ReachesAsFarBeyondTheBordersAsItsToolMovesAlongThem) {
  PeriodicPath path = short_period();
  path.lowest[1] = -7e-3;
  const auto spheres = make_periodic_wall_spheres(plate(), {}, path, 1e-3, "plate");
  double lowest = 0, highest = 0;
  for (const auto& centre : spheres.centres) {
    lowest = std::min(lowest, centre.y());
    highest = std::max(highest, centre.y());
  }
  EXPECT_GT(highest - 7e-3, 1e-3) << "moved by the whole way it does not cover the period";
  EXPECT_LT(lowest, -1.5e-3);
  path.turns = true;
  auto notched = plate();
  notched.vertices.emplace_back(0, 0, 1e-3);
  EXPECT_THROW(make_periodic_wall_spheres(notched, {}, path, 1e-3, "plate"), SceneError);
}

TEST(PeriodicWall, StandsInEveryPeriodWhereItsToolStaysWithinOne) {
  const PeriodicPath path{.period = {std::nullopt, 4e-3, std::nullopt}, .clearance = kGrain};
  const auto blade = box({-2e-3, -0.5e-3, -2e-3}, {2e-3, 0.5e-3, 0});
  const geometry::WallSphereOptions options;
  const auto one = geometry::make_wall_spheres(blade, options);
  const auto all = make_periodic_wall_spheres(blade, options, path, 4e-3, "blade");
  EXPECT_EQ(all.centres.size(), 3 * one.centres.size());
  PeriodicPath moving = path;
  moving.highest[1] = 1e-3;
  EXPECT_THROW(make_periodic_wall_spheres(blade, options, moving, 4e-3, "blade"), SceneError);
  PeriodicPath of_a_die = path;
  of_a_die.may_stand_within = false;
  EXPECT_THROW(make_periodic_wall_spheres(blade, options, of_a_die, 4e-3, "die"), SceneError);
}

Scene open_box(const std::string& preset) {
  Scene scene;
  scene.powder = powder_preset(preset);
  scene.pour.lower = {-4e-3, -4e-3, 0};
  scene.pour.upper = {4e-3, 4e-3, 10e-3};
  scene.pour.fill_height = 5e-3;
  return scene;
}

Tooling floor_below() {
  Tooling tooling;
  tooling.standing.include(Eigen::Vector3d::Constant(-1));
  tooling.standing.include(Eigen::Vector3d::Constant(1));
  return tooling;
}

TEST(Pour, GivesTheMassThatTheFillHeightNeedsAndNoOverlap) {
  for (const auto* preset : {"ASC100.29 initial A", "ASC100.29 D2"}) {
    const Scene scene = open_box(preset);
    const auto settings = engine_settings(scene, 1.0);
    const auto& shape = settings.shape();
    const auto grains = pour(scene, settings, floor_below());
    const double solid = static_cast<double>(grains.size()) * shape.solid_volume;
    EXPECT_NEAR(solid, 8e-3 * 8e-3 * 5e-3 * expected_solid_fraction(scene), shape.solid_volume) << preset;
    for (std::size_t k = 1; k < grains.size(); ++k)
      EXPECT_GT((grains[k].position - grains[k - 1].position).norm(), 0.99 * 2 * shape.bounding_radius());
  }
}

TEST(Pour, GoesAroundToolsOnlyWhereAsked) {
  Scene scene = open_box("ASC100.29 D2");
  const auto settings = engine_settings(scene, 1.0);
  const auto& shape = settings.shape();
  Tooling tooling = floor_below();
  Tool stirrer;
  stirrer.mesh = box({-1e-3, -5e-3, 1e-3}, {1e-3, 5e-3, 3e-3});
  tooling.tools.push_back(stirrer);
  EXPECT_THROW(pour(scene, settings, tooling), SceneError);
  scene.pour.around_tools = true;
  const auto grains = pour(scene, settings, tooling);
  EXPECT_EQ(grains.size(), grains_to_pour(scene));
  const geometry::SolidQuery solid(stirrer.mesh);
  for (const auto& grain : grains)
    EXPECT_GT(solid.signed_distance(grain.position), 0.9 * shape.bounding_radius());
}

/// What pouring complains of.
std::string complaint(const Scene& scene, const Tooling& tooling) {
  try {
    pour(scene, engine_settings(scene, 1.0), tooling);
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

TEST(Pour, RefusesALidOverTheBoxAndSaysHowMuchFitsBeneath) {
  Scene scene = open_box("ASC100.29 D2");
  const auto settings = engine_settings(scene, 1.0);
  const double above = scene.pour.lower[2] + scene.pour.fill_height + 4 * settings.shape().bounding_radius();
  ASSERT_GT(pour_height(scene, settings), above + 2e-3);
  Tooling tooling = floor_below();
  Tool lid;
  lid.spec.name = "lid";
  lid.mesh = box({-1, -1, above}, {1, 1, above + 2e-3});
  tooling.tools.push_back(lid);
  for (const bool around : {false, true}) {
    scene.pour.around_tools = around;
    const std::string said = complaint(scene, tooling);
    EXPECT_NE(said.find("tool \"lid\""), std::string::npos) << said;
    const std::size_t place = said.find("pour at most ");
    ASSERT_NE(place, std::string::npos) << said;
    Scene less = scene;
    less.pour.fill_height = 1e-3 * std::stod(said.substr(place + 13));
    ASSERT_GT(less.pour.fill_height, 0.2 * scene.pour.fill_height);
    EXPECT_EQ(complaint(less, tooling), "") << "what it says does fit";
  }
}

TEST(Pour, DependsOnTheSeedAlone) {
  Scene scene = open_box("ASC100.29 D2");
  const auto settings = engine_settings(scene, 1.0);
  const auto first = pour(scene, settings, floor_below()), again = pour(scene, settings, floor_below());
  scene.seed = 2;
  const auto other = pour(scene, settings, floor_below());
  EXPECT_EQ(first[7].position, again[7].position);
  EXPECT_EQ(first[7].orientation, again[7].orientation);
  EXPECT_NE(first[7].position, other[7].position);
}

TEST(RestWatch, WaitsForQuietPowderAndSeesItFall) {
  Scene scene = open_box("ASC100.29 initial A");
  auto settings = engine_settings(scene, 1.0);
  settings.gravity.setZero();
  settings.air_viscosity = 0;
  engine::Simulation drifting(settings, {});
  drifting.add_grains({engine::NewGrain{.velocity = {0.1, 0, 0}}});
  RestWatch watch;
  // No gravity, no energy scale: a drifting grain is never quiet, and its centre of mass moves.
  for (int n = 0; n < 2000; ++n) drifting.step();
  EXPECT_FALSE(watch.at_rest(drifting, 3e-4));
  for (int n = 0; n < 2000; ++n) drifting.step();
  EXPECT_FALSE(watch.at_rest(drifting, 3e-4));
}

class CheckpointFile : public testing::Test {
 protected:
  support::TemporaryFolder folder_;
};

TEST_F(CheckpointFile, GivesBackEveryBitAndContinuesTheSameRun) {
  const Scene scene = open_box("ASC100.29 D2");
  engine::Simulation original(engine_settings(scene, 1.0), {});
  original.add_grains(pour(scene, original.settings(), floor_below()));
  for (int n = 0; n < 300; ++n) original.step();
  Checkpoint kept;
  kept.scene_hash = 42;
  kept.start_hash = 43;
  kept.simulation = original.snapshot();
  kept.schedule.steps.resize(3);
  kept.schedule.steps[1].until.rest.quiet_since = 0.25;
  kept.schedule.steps[2].control.integral = 0.125;
  kept.schedule.loads.resize(2);
  kept.schedule.loads[1].force = {1, 2, 3};
  kept.probes.rows = {1, 2, 3};
  kept.snapshots.resize(1);
  kept.snapshots[0].taken = 4;
  kept.grains_removed = {3, 4};
  kept.grains_sheared = {3};
  kept.leaks = {2, true};
  kept.strays = {3, 1, {1, 2, 3}, 0.5};
  kept.warnings.speed = true;
  kept.warnings.texts = {"a grain was fast", ""};
  write_checkpoint(checkpoint_file(folder_.path()), kept);
  const auto read = read_checkpoint(checkpoint_file(folder_.path()));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->scene_hash, 42U);
  EXPECT_EQ(read->start_hash, 43U);
  ASSERT_EQ(read->schedule.steps.size(), 3U);
  EXPECT_EQ(read->schedule.steps[1].until.rest.quiet_since, 0.25);
  EXPECT_EQ(read->schedule.steps[2].control.integral, 0.125);
  EXPECT_EQ(read->schedule.loads.at(1).force, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(read->probes.rows, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(read->snapshots.at(0).taken, 4U);
  EXPECT_EQ(read->grains_removed, kept.grains_removed);
  EXPECT_EQ(read->grains_sheared, kept.grains_sheared);
  EXPECT_EQ(read->leaks.grains, 2U);
  EXPECT_TRUE(read->leaks.warned);
  EXPECT_EQ(read->strays.grains, 3U);
  EXPECT_EQ(read->strays.tool, 1U);
  EXPECT_EQ(read->strays.place, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(read->strays.time, 0.5);
  EXPECT_TRUE(read->warnings.speed);
  EXPECT_FALSE(read->warnings.contacts);
  EXPECT_EQ(read->warnings.texts, kept.warnings.texts);
  engine::Simulation resumed(original.settings(), {});
  resumed.restore(read->simulation);
  for (int n = 0; n < 300; ++n) {
    original.step();
    resumed.step();
  }
  EXPECT_EQ(resumed.hash(), original.hash());
}

TEST_F(CheckpointFile, IsNothingWhereThereIsNoneAndAnErrorWhereItIsDamaged) {
  EXPECT_FALSE(read_checkpoint(checkpoint_file(folder_.path())).has_value());
  std::ofstream(checkpoint_file(folder_.path())) << "no checkpoint at all";
  EXPECT_THROW(read_checkpoint(checkpoint_file(folder_.path())), results::ResultError);
}

TEST_F(CheckpointFile, OfTheLayoutBeforeIsRefusedInWords) {
  const auto file = checkpoint_file(folder_.path());
  write_checkpoint(file, {});
  std::string bytes = support::contents(file);
  ASSERT_EQ(bytes.substr(0, 8), "dfchkp22");
  folder_.write(file.filename().string(), bytes.replace(7, 1, "1"));
  try {
    read_checkpoint(file);
    FAIL() << "it was read";
  } catch (const results::ResultError& error) {
    const std::string message = error.what();
    for (const char* part :
         {"checkpoint.bin", "not a checkpoint of this program version", "without --resume"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace diefill::process
