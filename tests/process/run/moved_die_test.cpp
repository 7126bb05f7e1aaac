// Frames of results where the die moves, and of tools without a die; what is measured in cavities while a run
// goes on.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/observe/powder_figures.h"
#include "process/run/assemble.h"
#include "process/run/kept_instants.h"
#include "process/tooling/die_frame.h"
#include "tests/process/run/on_a_plate.h"

namespace diefill::process {
namespace {

constexpr const char* kSpheres = "preset = \"ASC100.29 initial A\"\n";
constexpr const char* kAtOnce = "[[step]]\nkind = \"settle\"\nduration = \"1 ms\"\nfrom_start = true\n\n";
constexpr const char* kSideways =
    "[[step]]\nkind = \"move\"\ntool = \"die\"\ndirection = \"x\"\ndistance = \"3 mm\"\nvelocity = \"0.3 "
    "m/s\"\n\n[[step]]\nkind = \"wait\"\nduration = \"1 s\"\n";
constexpr double kWay = 3e-3;  // m

/// A plate that goes 3 mm sideways while powder falls on it; instants are kept every 5 ms.
std::unique_ptr<FillRun> moved_plate(OnAPlate& plate) {
  plate.scene.measure.snapshot_interval = 5e-3;
  return plate.run_until(0.05);
}

TEST(MovedDie, InstantsAreInItsFrameAsItWasThen) {
  OnAPlate plate(kSpheres, "", std::string(kAtOnce) + kSideways);
  const auto run = moved_plate(plate);
  const auto result = powder_and_tools(plate.scene, plate.tooling, *run);
  const auto kept = kept_instants(plate.tooling, *run, result.powder);
  ASSERT_EQ(kept.size(), run->instants().size());
  ASSERT_GT(kept.size(), 3U);
  double way = 0;
  for (std::size_t n = 0; n < kept.size(); ++n) {
    const results::Instant& raw = run->instants()[n];
    const Eigen::Vector3d moved = raw.tool_displacement.front();
    EXPECT_GE(moved.x(), way) << "the plate moves on";
    way = moved.x();
    EXPECT_LT((kept[n].position.front() - (raw.position.front() - moved)).norm(), 1e-15);
    EXPECT_EQ(kept[n].velocity, raw.velocity);
    EXPECT_LT(kept[n].tool_displacement.front().norm(), 1e-15) << "the plate is where the results have it";
  }
  EXPECT_NEAR(way, kWay, 1e-12);
  EXPECT_LT((result.powder.position.front() -
             (run->simulation().grains().position.front() - Eigen::Vector3d(kWay, 0, 0)))
                .norm(),
            1e-15);
}

TEST(MovedDie, ThatComesBackHasItsInstantsInTheLaboratoryFrame) {
  OnAPlate plate(kSpheres, "",
                 std::string(kAtOnce) +
                     "[[step]]\nkind = \"vibration\"\ntool = \"die\"\naxis = \"x\"\namplitude = \"1 mm\"\n"
                     "frequency = \"100 Hz\"\nduration = \"20 ms\"\nramp = \"5 ms\"\n\n[[step]]\nkind = "
                     "\"wait\"\nduration = \"1 s\"\n");
  plate.scene.measure.snapshot_interval = 2e-3;
  const auto run = plate.run_until(0.03);
  const auto result = powder_and_tools(plate.scene, plate.tooling, *run);
  const auto kept = kept_instants(plate.tooling, *run, result.powder);
  double farthest = 0;
  for (std::size_t n = 0; n < kept.size(); ++n) {
    EXPECT_EQ(kept[n].position, run->instants()[n].position);
    farthest = std::max(farthest, kept[n].tool_displacement.front().norm());
  }
  EXPECT_GT(farthest, 1e-4);
}

TEST(MovedDie, ToolsWithoutADieHaveResultsInTheLaboratoryFrame) {
  OnAPlate plate(kSpheres, "", std::string(kAtOnce) + kSideways);
  plate.tooling.tools[0].spec.role = plate.scene.tools[0].role = ToolRole::plate;
  const auto run = moved_plate(plate);
  const auto result = powder_and_tools(plate.scene, plate.tooling, *run);
  EXPECT_EQ(result.powder.position, run->simulation().grains().position);
  const geometry::Mesh& mesh = plate.tooling.tools[0].mesh;
  EXPECT_NEAR(result.tools.front().vertices.front().x(), mesh.vertices.front().x() + kWay, 1e-12);
  const auto kept = kept_instants(plate.tooling, *run, result.powder);
  ASSERT_FALSE(kept.empty());
  EXPECT_EQ(kept.front().position, run->instants().front().position);
  EXPECT_NEAR(kept.front().tool_displacement.front().x(),
              run->instants().front().tool_displacement.front().x() - kWay, 1e-12);
}

/// m; without the parts of it that have no use here.
geometry::Cavity box_cavity(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  geometry::Cavity cavity;
  cavity.found = true;
  cavity.box.lower = lower;
  cavity.box.upper = upper;
  cavity.volume = cavity.box.size().prod();
  cavity.narrowest_width = cavity.box.size().head<2>().minCoeff();
  cavity.footprint = {lower.head<2>(), cavity.box.size().x() / 2, {2, 1}, {1, 1}};
  return cavity;
}

TEST(MovedDie, FilledMassIsThatInAllCavities) {
  OnAPlate plate(kSpheres);
  plate.tooling.cavity = box_cavity({-1e-2, -1e-2, 0}, {0, 1e-2, 0.05});
  plate.tooling.other_cavities = {box_cavity({0, -1e-2, 0}, {1e-2, 1e-2, 0.05})};
  const auto run = plate.run_until(1e-3);
  const double all = engine::powder_mass(run->simulation());
  EXPECT_NEAR(filled_mass(run->simulation(), plate.tooling), all, 1e-9 * all);
  plate.tooling.other_cavities.clear();
  const double half = filled_mass(run->simulation(), plate.tooling);
  EXPECT_GT(half, 0.3 * all);
  EXPECT_LT(half, 0.7 * all);
}

/// Rows of the first probe, with its columns.
results::ProbeSeries first_probe(OnAPlate& plate, double until) {
  return plate.run_until(until)->probes().front();
}

TEST(MovedDie, FillLevelLeavesOutWhatIsBesideTheCavityInItsBox) {
  const std::string probe = "[[probe]]\nname = \"level\"\nquantity = \"fill level\"\n";
  const auto lowest = [&](std::uint8_t right) {
    OnAPlate plate(kSpheres, "", "[[step]]\nkind = \"wait\"\nduration = \"1 s\"\n\n" + probe);
    // Powder lies between -1 and 1 mm only.
    plate.tooling.cavity = box_cavity({-1e-3, -1e-3, 0}, {3e-3, 1e-3, 5e-3});
    plate.tooling.cavity.footprint.covered = {1, right};
    const auto series = first_probe(plate, 5e-3);
    EXPECT_EQ(series.columns.at(2), "lowest level");
    return series.values.back();
  };
  EXPECT_EQ(lowest(1), 0);
  EXPECT_GT(lowest(0), 1e-4);
}

TEST(MovedDie, ShiftOfALoadIsThatOfTheOriginOfTheFile) {
  OnAPlate plate(kSpheres, "",
                 std::string(kAtOnce) +
                     "[[step]]\nkind = \"rotation\"\ntool = \"die\"\naxis = \"z\"\nthrough = [\"0 mm\", \"0 "
                     "mm\", \"0 mm\"]\nspeed = \"3000 rpm\"\nramp = \"5 ms\"\nduration = \"15 ms\"\n\n"
                     "[[step]]\nkind = \"wait\"\nduration = \"1 s\"\n\n[[probe]]\nname = \"load\"\n"
                     "quantity = \"load\"\ntool = \"die\"\n");
  plate.tooling.tools[0].spec.position = plate.scene.tools[0].position = {5e-3, 0, 0};
  const auto series = first_probe(plate, 0.04);
  const std::size_t columns = series.columns.size();
  ASSERT_EQ(series.columns.at(columns - 3), "shift x");
  ASSERT_GT(series.values.size(), columns);
  EXPECT_NEAR(series.values.at(series.values.size() - 3), -10e-3, 1e-9);
  EXPECT_NEAR(series.values.at(series.values.size() - 2), 0, 1e-9);
}

}  // namespace
}  // namespace diefill::process
