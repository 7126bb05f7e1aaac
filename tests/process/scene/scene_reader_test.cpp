// A full scene with every key set ends up in the typed scene; a short one has the documented defaults.
#include <gtest/gtest.h>

#include "process/machine/motions/passage.h"
#include "process/scene/scene.h"
#include "tests/process/scene_files.h"
#include "tests/support/scene_text.h"

namespace diefill::process {
namespace {

std::string full_scene() {
  support::SceneTables tables;
  tables.top = R"(title = "Everything"
seed = 42
gravity = "1.62 m/s^2"
)";
  tables.powder = R"(preset = "ASC100.29 D2"
model = "D"
sphere_radius = "0.08 mm"
grain_mass = "0.08 mg"
grain_diameter = "0.96 mm"
friction = 0.9
work_of_adhesion = "0.02 J/m^2"
rolling_friction = "0 mm"
reduced_modulus = "5 MPa"
damping_over_radius = "2e5 Pa s/m"
tangential_over_radius = "3 MPa"
air_viscosity = "1e-5 Pa s"
coarse_graining = "bierwisch"
)";
  tables.walls = R"(sphere_radius = "0.2 mm"
spacing = 1.5
friction = 0.2
work_of_adhesion = "1 mJ/m^2"
)";
  tables.shoe = R"(length_unit = "inch"
position = ["35 mm", "-1 mm", "2 um"]
rotation = { axis = "z", angle = "90 deg" }
sphere_radius = "0.1 mm"
spacing = 1.2
)";
  tables.pour = R"(from = ["20 mm", "-5 mm", "0 mm"]
to = ["50 mm", "5 mm", "90 mm"]
fill_height = "20 mm"
solid_fraction = 0.4
rim_speed = "0.02 m/s"
lattice_constant = 1.5
random_offset = 0.2
)";
  tables.steps = R"([[step]]
kind = "settle"
[[step]]
kind = "passage"
tool = "shoe"
velocity = "90 mm/s"
passages = 6
direction = "+y"
acceleration = "5 m/s^2"
clearance = "3 mm"
pause = "40 ms"
travel = "70 mm"
[[step]]
kind = "wait"
duration = "0.1 s"
)";
  tables.numerics = R"(time_step = "1 us"
lever_arm = "contact"
tangential_spring = "free"
opening = "centres"
periodic = { y = "10 mm" }
most_sheared = 0.02
max_time = "2 s"
checkpoint_interval = "2 min"
)";
  tables.measure = R"(fill_plane = "-1 mm"
averaging_width = "0.7 mm"
azimuth_bins = 72
snapshot_interval = "20 ms"
[[measure.section]]
name = "across"
origin = ["1 mm", "0 mm", "-2 mm"]
normal = [0, 3, 4]
[[measure.section]]
name = "along"
normal = "-x"
)";
  return support::scene_text(tables);
}

class FullScene : public testing::Test {
 protected:
  SceneFolder folder_;
  Scene scene_ = read_scene(folder_.write(full_scene()));
};

TEST_F(FullScene, KeepsTitleSeedGravityAndText) {
  EXPECT_EQ(scene_.title, "Everything");
  EXPECT_EQ(scene_.seed, 42U);
  EXPECT_EQ(scene_.gravity, Eigen::Vector3d(0, 0, -1.62));
  EXPECT_EQ(scene_.text, full_scene());
  EXPECT_EQ(scene_.file, folder_.path() / "scene.toml");
  EXPECT_EQ(scene_.coarse_graining, CoarseGraining::bierwisch);
}

TEST_F(FullScene, KeepsThePowderAndWalls) {
  EXPECT_EQ(scene_.powder.name, "ASC100.29 D2");
  EXPECT_DOUBLE_EQ(scene_.powder.sphere_radius, 8e-5);
  EXPECT_DOUBLE_EQ(scene_.powder.grain_mass, 8e-8);
  EXPECT_DOUBLE_EQ(scene_.powder.grain_diameter, 9.6e-4);
  EXPECT_DOUBLE_EQ(scene_.powder.friction, 0.9);
  EXPECT_DOUBLE_EQ(scene_.powder.work_of_adhesion, 0.02);
  EXPECT_DOUBLE_EQ(scene_.powder.reduced_modulus, 5e6);
  EXPECT_DOUBLE_EQ(scene_.powder.damping_over_radius, 2e5);
  EXPECT_DOUBLE_EQ(scene_.powder.tangential_over_radius, 3e6);
  EXPECT_DOUBLE_EQ(scene_.powder.air_viscosity, 1e-5);
  EXPECT_DOUBLE_EQ(scene_.walls.sphere_radius, 2e-4);
  EXPECT_DOUBLE_EQ(scene_.walls.spacing, 1.5);
  EXPECT_DOUBLE_EQ(scene_.walls.friction, 0.2);
  EXPECT_DOUBLE_EQ(scene_.walls.work_of_adhesion, 1e-3);
}

TEST_F(FullScene, KeepsTheTools) {
  ASSERT_EQ(scene_.tools.size(), 2U);
  const ToolSpec &die = scene_.tools[0], &shoe = scene_.tools[1];
  EXPECT_EQ(die.name, "die");
  EXPECT_EQ(die.role, ToolRole::die);
  EXPECT_EQ(die.file, folder_.path() / "die.stl");
  EXPECT_DOUBLE_EQ(die.metres_per_unit, 1e-3);
  EXPECT_EQ(die.rotation, Eigen::Matrix3d::Identity());
  EXPECT_EQ(die.position, Eigen::Vector3d::Zero());
  EXPECT_FALSE(die.sphere_radius || die.spacing);
  EXPECT_EQ(die.line, 26);
  EXPECT_EQ(shoe.line, 32);
  EXPECT_EQ(shoe.role, ToolRole::shoe);
  EXPECT_DOUBLE_EQ(shoe.metres_per_unit, 0.0254);
  EXPECT_TRUE(shoe.position.isApprox(Eigen::Vector3d(0.035, -0.001, 2e-6), 1e-14));
  EXPECT_TRUE((shoe.rotation * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-14));
  EXPECT_DOUBLE_EQ(*shoe.sphere_radius, 1e-4);
  EXPECT_DOUBLE_EQ(*shoe.spacing, 1.2);
}

TEST_F(FullScene, KeepsThePour) {
  EXPECT_TRUE(scene_.pour.lower.isApprox(Eigen::Vector3d(0.02, -0.005, 0), 1e-14));
  EXPECT_TRUE(scene_.pour.upper.isApprox(Eigen::Vector3d(0.05, 0.005, 0.09), 1e-14));
  EXPECT_DOUBLE_EQ(scene_.pour.fill_height, 0.02);
  EXPECT_DOUBLE_EQ(scene_.pour.solid_fraction, 0.4);
  EXPECT_DOUBLE_EQ(scene_.pour.rim_speed, 0.02);
  EXPECT_DOUBLE_EQ(scene_.pour.lattice_constant, 1.5);
  EXPECT_DOUBLE_EQ(scene_.pour.random_offset, 0.2);
}

TEST_F(FullScene, KeepsTheSteps) {
  ASSERT_EQ(scene_.steps.size(), 3U);
  EXPECT_EQ(scene_.steps[0]->duration(), std::nullopt);
  EXPECT_DOUBLE_EQ(*scene_.steps[2]->duration(), 0.1);
  const auto* passage = dynamic_cast<const Passage*>(scene_.steps[1].get());
  ASSERT_NE(passage, nullptr);
  EXPECT_EQ(passage->tools(), std::vector<std::string>{"shoe"});
  EXPECT_DOUBLE_EQ(passage->spec().velocity, 0.09);
  EXPECT_DOUBLE_EQ(passage->spec().acceleration, 5);
  EXPECT_EQ(passage->spec().passages, 6);
  EXPECT_EQ(passage->spec().direction, Eigen::Vector3d::UnitY());
  EXPECT_DOUBLE_EQ(passage->spec().clearance, 3e-3);
  EXPECT_DOUBLE_EQ(passage->spec().pause, 0.04);
  EXPECT_DOUBLE_EQ(*passage->spec().travel, 0.07);
  EXPECT_EQ(strategy_text(scene_), "6 passages at 0.09 m/s, then a wait of 0.1 s");
}

TEST_F(FullScene, KeepsNumericsAndMeasure) {
  const NumericsSpec& numerics = scene_.numerics;
  EXPECT_EQ(numerics.time_step_fraction, 0);
  EXPECT_DOUBLE_EQ(*numerics.time_step, 1e-6);
  EXPECT_EQ(numerics.lever_arm, LeverArm::contact);
  EXPECT_EQ(numerics.tangential_spring, TangentialSpring::free);
  EXPECT_EQ(numerics.opening, OpeningMeasure::centres);
  EXPECT_FALSE(numerics.period[0]);
  EXPECT_DOUBLE_EQ(*numerics.period[1], 0.01);
  EXPECT_EQ(numerics.pinched_grains, PinchedGrains::shear_off);
  EXPECT_EQ(numerics.most_sheared, 0.02);
  EXPECT_DOUBLE_EQ(numerics.max_time, 2);
  EXPECT_DOUBLE_EQ(numerics.checkpoint_interval, 120);
  EXPECT_DOUBLE_EQ(scene_.measure.fill_plane.value(), -1e-3);
  EXPECT_DOUBLE_EQ(scene_.measure.averaging_width, 7e-4);
  EXPECT_EQ(scene_.measure.azimuth_bins, 72);
  EXPECT_DOUBLE_EQ(scene_.measure.snapshot_interval, 0.02);
  ASSERT_EQ(scene_.measure.sections.size(), 2U);
  EXPECT_EQ(scene_.measure.sections[0].name, "across");
  EXPECT_TRUE(scene_.measure.sections[0].origin.isApprox(Eigen::Vector3d(1e-3, 0, -2e-3), 1e-14));
  EXPECT_TRUE(scene_.measure.sections[0].normal.isApprox(Eigen::Vector3d(0, 0.6, 0.8), 1e-14));
  EXPECT_EQ(scene_.measure.sections[1].normal, Eigen::Vector3d(-1, 0, 0));
}

/// The shortest scene, with these lines in [powder] and at the end of [pour].
Scene short_scene(const std::string& powder, const std::string& pour = {}) {
  const SceneFolder folder;
  return read_scene(folder.write("[powder]\n" + powder + R"(
[[tool]]
name = "plate"
role = "plate"
file = "die.stl"
length_unit = "mm"
[pour]
from = ["0 mm", "0 mm", "0 mm"]
to = ["20 mm", "20 mm", "20 mm"]
fill_height = "5 mm"
)" + pour));
}

TEST(ShortScene, HasTheDocumentedDefaults) {
  const Scene scene = short_scene("preset = \"Distaloy AE\"");
  EXPECT_EQ(scene.title, "scene");
  EXPECT_EQ(scene.seed, 1U);
  EXPECT_EQ(scene.gravity, Eigen::Vector3d(0, 0, -9.81));
  EXPECT_TRUE(scene.steps.empty());
  EXPECT_EQ(strategy_text(scene), "no motion");
  EXPECT_EQ(scene.walls.sphere_radius, 1.5e-4);
  EXPECT_EQ(scene.walls.spacing, 1.6);
  EXPECT_EQ(scene.walls.friction, 0.15);
  EXPECT_EQ(scene.walls.work_of_adhesion, 0);
  EXPECT_EQ(scene.pour.solid_fraction, 0);
  EXPECT_EQ(scene.pour.lattice_constant, 0);  // chosen after the grain model
  EXPECT_EQ(scene.pour.random_offset, 0.1);
  EXPECT_EQ(scene.numerics.time_step_fraction, 0);
  EXPECT_FALSE(scene.numerics.time_step);
  EXPECT_EQ(scene.numerics.lever_arm, LeverArm::contact);
  EXPECT_EQ(scene.numerics.tangential_spring, TangentialSpring::cut_back);
  EXPECT_EQ(scene.numerics.opening, OpeningMeasure::surfaces);
  EXPECT_EQ(scene.numerics.pinched_grains, PinchedGrains::shear_off);
  EXPECT_EQ(scene.numerics.most_sheared, 0.005);
  EXPECT_EQ(scene.numerics.max_time, 0);
  EXPECT_EQ(scene.numerics.checkpoint_interval, 60);
  EXPECT_EQ(scene.measure.azimuth_bins, 36);
  EXPECT_EQ(scene.measure.snapshot_interval, 0);
  EXPECT_TRUE(scene.measure.sections.empty());
}

/// Offset and lattice of the pour of short_scene.
std::pair<double, double> start_of(const std::string& powder, const std::string& pour) {
  const PourSpec read = short_scene(powder, pour).pour;
  return {read.random_offset, read.lattice_constant};
}

TEST(Pour, StartsSpheresThatWouldSettleInColumnsFromRandomPlaces) {
  using Start = std::pair<double, double>;
  EXPECT_EQ(start_of("preset = \"ASC100.29 A1\"", ""), Start(0.5, 2));
  EXPECT_EQ(start_of("preset = \"ASC100.29 A2\"", ""), Start(0.1, 0));  // does not stick
  EXPECT_EQ(start_of("preset = \"ASC100.29 A2\"\nwork_of_adhesion = \"0.001 J/m^2\"", ""), Start(0.5, 2));
  EXPECT_EQ(start_of("preset = \"ASC100.29 B1\"", ""), Start(0.1, 0));  // rotates
  EXPECT_EQ(start_of("preset = \"ASC100.29 A1\"", "lattice_constant = 1.3"), Start(0.1, 1.3));
  EXPECT_EQ(start_of("preset = \"ASC100.29 A1\"", "random_offset = 0.2\nlattice_constant = 3"),
            Start(0.2, 3));
}

TEST(ToolRoles, AreSpeltAsInTheScene) {
  EXPECT_EQ(description(ToolRole::die), "die");
  EXPECT_EQ(description(ToolRole::core), "core");
  EXPECT_EQ(description(ToolRole::punch), "punch");
  EXPECT_EQ(description(ToolRole::shoe), "shoe");
  EXPECT_EQ(description(ToolRole::plate), "plate");
}

}  // namespace
}  // namespace diefill::process
