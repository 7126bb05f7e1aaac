// A run whose tools are their meshes, from scene to report.
#include <gtest/gtest.h>

#include "tests/app/shared_report.h"

namespace diefill::app {
namespace {

TEST(MeshWalls, FillAndLoseNothingOnAnyNumberOfThreads) {
  const SmallDie die;
  die.exchange("sphere_radius = \"0.25 mm\"", "sphere_radius = \"0.25 mm\"\nkind = \"mesh\"");
  const Outcome checked = die.check();
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  EXPECT_NE(checked.out.find("walls: the mesh itself"), std::string::npos) << checked.out;
  ASSERT_EQ(die.run({"--no-pictures"}).exit_code, 0);
  const auto alone = die.report();
  EXPECT_EQ(alone.at("grains").get<double>() + alone.at("grains_left").get<double>() +
                alone.at("grains_sheared").get<double>(),
            138);
  EXPECT_GT(alone.at("filled_mass_kg").get<double>(), 0.2 * 64e-9 * 5397);
  EXPECT_LT(std::abs(alone.at("energy_balance_error").get<double>()), 0.005);
  const Outcome together = run_program(
      {"run", die.scene().string(), "--out", die.out().string(), "--no-pictures", "--threads", "2"});
  ASSERT_EQ(together.exit_code, 0) << together.err;
  EXPECT_EQ(die.report().at("state_hash"), alone.at("state_hash"));
}

TEST(MeshWalls, OtherWallsAreOtherRuns) {
  double spheres_fill = 0,
         mesh_fill = 0;  // kg, mean over seeds: a single pocket of two dozen grains scatters
  for (const char* seed : {"1", "2", "3", "4"}) {
    const SmallDie spheres, mesh;
    mesh.exchange("role = \"die\"", "role = \"die\"\nwalls = \"mesh\"");
    for (const SmallDie* die : {&spheres, &mesh}) die->exchange("seed = 1", std::string("seed = ") + seed);
    const auto of_spheres = shared_report(spheres), of_mesh = shared_report(mesh);
    EXPECT_NE(of_mesh.at("state_hash"), of_spheres.at("state_hash"));
    spheres_fill += of_spheres.at("filled_mass_kg").get<double>() / 4;
    mesh_fill += of_mesh.at("filled_mass_kg").get<double>() / 4;
  }
  EXPECT_NEAR(spheres_fill, mesh_fill, 0.3 * spheres_fill);
}

}  // namespace
}  // namespace diefill::app
