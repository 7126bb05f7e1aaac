// A run from powder above a plate to its figures: spheres of unlike grains, overlaps, warnings after a
// restart.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/observe/powder_figures.h"
#include "process/run/assemble.h"
#include "tests/process/run/on_a_plate.h"

namespace diefill::process {
namespace {

TEST(FillRun, CountsTheSpheresOfEveryGrain) {
  OnAPlate clumps_and_spheres("preset = \"ASC100.29 D2\"\n",
                              "[[other_powder]]\nname = \"copper\"\nshare = 0.5\nmodel = \"A\"\n"
                              "sphere_radius = \"0.1 mm\"\ngrain_mass = \"2.6e-8 kg\"\n");
  const auto run = clumps_and_spheres.run_until(2e-4);
  std::size_t spheres = 0;
  for (std::size_t k = 0; k < run->simulation().grains().size(); ++k)
    spheres += run->simulation().grains().kind[k] == 0 ? 7 : 1;
  EXPECT_GT(spheres, run->simulation().grains().size());
  EXPECT_LT(spheres, 6 * run->simulation().grains().size());
  EXPECT_EQ(engine::sphere_count(run->simulation()), spheres);
  EXPECT_EQ(run->sphere_steps(), spheres * run->simulation().steps());
}

TEST(FillRun, MeasuresTheOverlapOfUnequalSpheresByTheirOwnRadius) {
  OnAPlate clumps(
      "spheres = [{ centre = [\"0 mm\", \"0 mm\", \"0 mm\"], radius = \"0.2 mm\" }, { centre = [\"0.2 mm\", "
      "\"0 mm\", \"0 mm\"], radius = \"0.05 mm\" }]\ngrain_mass = \"1e-7 kg\"\n");
  const auto run = clumps.run_until(0.015);
  const engine::DeepestOverlap& deepest = run->simulation().overlaps_of_run();
  ASSERT_GT(deepest.walls, 0);
  results::FillResult result;
  add_margin_figures(result, *run);
  EXPECT_EQ(result.figures.at("deepest_overlap_ratio"), deepest.grains_over_radius);
  EXPECT_EQ(result.figures.at("deepest_wall_overlap_ratio"), deepest.walls_over_radius);
  EXPECT_LT(deepest.walls_over_radius, deepest.walls / 0.05e-3) << "the larger spheres overlap most";
}

TEST(FillRun, StopsEveryGrainWhereAChangeSaysAtRest) {
  // They fall for 1 ms and then float.
  OnAPlate falling(
      "preset = \"Distaloy AE\"\n", "",
      "[[step]]\nkind = \"settle\"\nduration = \"1 ms\"\nfrom_start = true\n\n[[step]]\nkind = "
      "\"change\"\nat_rest = true\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n\n[[step]]\n"
      "kind = \"wait\"\nduration = \"1 s\"\n");
  const auto before = falling.run_until(0.9e-3);
  const double speed = before->simulation().grains().velocity.front().norm(),
               turning = before->simulation().grains().spin.front().norm();
  EXPECT_GT(speed, 8e-3);
  const auto after = falling.run_until(1.5e-3);
  const engine::Grains& grains = after->simulation().grains();
  ASSERT_GT(grains.size(), 10U);
  for (std::size_t k = 0; k < grains.size(); ++k) {
    EXPECT_LT(grains.velocity[k].norm(), 1e-5 * speed) << k << ": more than the drag of half a step";
    EXPECT_LE(grains.spin[k].norm(), 1e-3 * turning) << k;
  }
}

// Along x, with the period: every grain passes the plane two or three times.
TEST(FillRun, FlowOfPowderThatComesRoundAPeriodGoesOn) {
  OnAPlate carried(
      "preset = \"Distaloy AE\"\n", "",
      "[[step]]\nkind = \"settle\"\nduration = \"0.1 ms\"\nfrom_start = true\n\n[[step]]\nkind = "
      "\"change\"\ngravity = [\"100 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n\n[[step]]\nkind = \"wait\"\n"
      "duration = \"1 s\"\n\n[[probe]]\nname = \"round\"\nquantity = \"flow\"\norigin = [\"0 mm\", "
      "\"0 mm\", \"0 mm\"]\nnormal = \"x\"\n",
      "periodic = { x = \"4 mm\" }\n");
  const double whole_way = 10e-3;  // m
  const auto run = carried.run_until(std::sqrt(2 * whole_way / 100));
  const results::ProbeSeries flow = run->probes().front();
  ASSERT_EQ(flow.columns.at(1), "mass");
  std::vector<double> mass;
  for (std::size_t n = 1; n < flow.values.size(); n += flow.columns.size()) mass.push_back(flow.values[n]);
  ASSERT_GT(mass.size(), 10U);
  const double all = engine::powder_mass(run->simulation()), rounding = 1e-9 * all;
  for (std::size_t n = 1; n < mass.size(); ++n) EXPECT_GE(mass[n], mass[n - 1] - rounding) << n;
  EXPECT_GE(mass.back(), 1.9 * all) << "the last row is up to a millisecond old";
  EXPECT_LE(mass.back(), 3 * all + rounding);
}

TEST(FillRun, EndsWithTheWarningsOfAnUnbrokenRunAfterARestart) {
  const std::string soft = "preset = \"ASC100.29 initial A\"\nreduced_modulus = \"0.01 MPa\"\n";
  OnAPlate unbroken(soft), broken(soft);
  const auto of_whole_run = unbroken.run_until(0.026)->warnings();
  ASSERT_EQ(of_whole_run.size(), 2U) << "that it is unfinished, and of an overlap by t = 0.0249969 s";
  // Where a run stops it looks for itself, before an unbroken one does.
  for (const double stop : {0.02498, 0.0255})
    EXPECT_EQ(broken.run_until(stop)->warnings().size(), 2U) << stop;
  EXPECT_EQ(broken.run_until(0.026)->warnings(), of_whole_run);
}

TEST(FillRun, ThatCannotEndStopsUnfinishedAndSaysForWhat) {
  OnAPlate waiting("preset = \"ASC100.29 initial A\"\n", "",
                   "[[step]]\nkind = \"settle\"\nuntil = { filled_mass = \"5 mg\" }\n");
  const auto run = waiting.run_until(5);
  EXPECT_TRUE(run->cannot_end());
  EXPECT_TRUE(run->ended_early());
  EXPECT_LT(run->simulation().time(), 4);
  const std::string why = run->why_unfinished();
  for (const char* part :
       {"the scene cannot end: at t = ", "all powder is at rest, none comes in and no tool moves",
        "step.until waits for ", " in the cavity, which holds 0 "})
    EXPECT_NE(why.find(part), std::string::npos) << why;
}

TEST(FillRun, ThatCannotEndStopsAtTheSameInstantAfterARestart) {
  const std::string powder = "preset = \"ASC100.29 initial A\"\n",
                    steps = "[[step]]\nkind = \"settle\"\nuntil = { filled_mass = \"5 mg\" }\n";
  OnAPlate unbroken(powder, "", steps), broken(powder, "", steps);
  const double end = unbroken.run_until(5)->simulation().time();
  EXPECT_FALSE(broken.run_until(end - 0.1)->cannot_end());
  const auto rest = broken.run_until(5);
  EXPECT_TRUE(rest->cannot_end());
  EXPECT_EQ(rest->simulation().time(), end);
}

}  // namespace
}  // namespace diefill::process
