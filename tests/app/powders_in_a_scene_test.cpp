// Several powders in one scene through the real program: mixed and in layers, single spheres beside clumps,
// laws between them, restart, refusals; and a chute that is periodic along z.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <thread>

#include "process/results/storage/result_file.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

/// Single spheres beside the clumps or spheres of [powder]; `more` keys.
std::string copper(const std::string& more) {
  return "[[other_powder]]\nname = \"copper\"\n" + more +
         "model = \"A\"\nsphere_radius = \"0.1 mm\"\ngrain_mass = \"2.6e-8 kg\"\ngrain_diameter = \"0.9 "
         "mm\"\nreduced_modulus = \"3 MPa\"\nfriction = 0.2\n\n";
}

void add_before_tools(const SmallDie& die, const std::string& tables) {
  die.exchange("[[tool]]\nname = \"die\"", tables + "[[tool]]\nname = \"die\"");
}

nlohmann::json whole_report(const SmallDie& die) {
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  if (outcome.exit_code != 0) return {};
  auto report = die.report();
  EXPECT_LT(std::abs(report.at("energy_balance_error").get<double>()), 0.02);
  return report;
}

/// m, mean height of the grains of each powder.
std::vector<double> mean_heights(const results::PowderState& powder) {
  std::vector<double> sum(powder.kinds.size()), grains(powder.kinds.size());
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    sum[powder.kind[k]] += powder.position[k].z();
    grains[powder.kind[k]] += 1;
  }
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] /= grains[n];
  return sum;
}

TEST(SeveralPowders, FillADieMixed) {
  const SmallDie die;
  die.exchange("preset = \"ASC100.29 A2\"", "preset = \"ASC100.29 D2\"\nname = \"iron\"");
  add_before_tools(die, copper("share = 0.3\n"));
  const auto report = whole_report(die);
  EXPECT_EQ(report.at("powder"), "iron, copper");
  EXPECT_NEAR(report.at("first_powder_mass_share_all").get<double>(), 0.7, 0.05);
  const auto result = results::read_results(die.out());
  ASSERT_EQ(result.powder.kinds.size(), 2U);
  EXPECT_EQ(result.powder.kinds.spheres, (std::vector<std::uint32_t>{7, 1}));
  EXPECT_EQ(result.powder.sphere_centres().size(), result.powder.sphere_count());
  EXPECT_EQ(report.at("spheres").get<std::size_t>(), result.powder.sphere_count());
  EXPECT_EQ(result.powder.radii_of_spheres().size(), result.powder.sphere_count());
  const Outcome drawn = run_program(
      {"map", die.out().string(), "--picture", "view", "--out", (die.folder() / "maps").string()});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
}

TEST(SeveralPowders, LieInLayers) {
  const SmallDie die;
  die.pour_into_the_pocket();
  die.exchange("lattice_constant = 1.25",
               "lattice_constant = 1.25\nlayers = [{ powder = \"copper\", share = 0.5 }, { powder = "
               "\"ASC100.29 A2\", share = 0.5 }]");
  die.exchange_passage("[[step]]\nkind = \"settle\"\n");
  add_before_tools(die, copper(""));
  const auto report = whole_report(die);
  EXPECT_GT(report.at("first_powder_mass_share_all").get<double>(), 0);
  const auto heights = mean_heights(results::read_results(die.out()).powder);
  EXPECT_GT(heights.at(0), heights.at(1) + 0.5e-3) << "[powder] was poured on top";
}

TEST(SeveralPowders, HaveContactsOfTheirOwnAndResumeToTheSameBits) {
  const std::string contact =
      "[contact]\nnormal = { law = \"Hertz-Mindlin\", modulus = \"1.5 MPa\" }\ndamping = { law = "
      "\"restitution\", restitution = 0.3 }\nfriction = { law = \"Mindlin\", friction = 0.4, shear_modulus = "
      "\"0.6 MPa\" }\n\n";
  const SmallDie die, other;
  for (const SmallDie* each : {&die, &other}) {
    each->exchange("reduced_modulus = \"3 MPa\"\ndamping_over_radius = \"3e5 Pa s/m\"\n", "");
    std::string spheres = copper("share = 0.5\ncontact = { friction = { law = \"none\" } }\n");
    spheres.replace(spheres.find("reduced_modulus"), std::string::npos, "\n");
    add_before_tools(
        *each,
        contact + spheres + "[[powder_pair]]\npowders = [\"copper\", \"ASC100.29 A2\"]\nfriction = 0.1\n\n");
  }
  const auto whole = whole_report(other);
  for (int kills = 0; kills < 2; ++kills) {
    auto arguments = die.run_arguments({"--quiet", "--no-pictures"});
    if (kills > 0) arguments.push_back("--resume");
    Program program(arguments);
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    if (program.running()) program.send(SIGINT);
    program.wait();
  }
  ASSERT_EQ(die.run({"--quiet", "--no-pictures", "--resume"}).exit_code, 0);
  EXPECT_EQ(die.report().at("state_hash"), whole.at("state_hash"));
}

TEST(SeveralPowders, ThatMakeNoSenseAreRefused) {
  const struct {
    std::string tables, expected;
  } cases[] = {
      {copper(""), "other_powder.share: found nothing, a value is required"},
      {copper("share = 1.0\n"), "add up to 1"},
      {copper("share = 0.2\n") + copper("share = 0.2\n"), "another powder has this name"},
      {copper("share = 0.2\nair_viscosity = \"1e-5 Pa s\"\n"), "give it in [powder]"},
      {copper("share = 0.2\n") + "[[powder_pair]]\npowders = [\"copper\", \"iron\"]\nfriction = 0.1\n\n",
       "no powder has this name"},
      {"[[powder_pair]]\npowders = [\"copper\", \"iron\"]\nfriction = 0.1\n\n", "one powder only"},
      {copper("share = 0.2\ncontact = { friction = { law = \"none\" } }\n"), "add [contact]"},
      {copper("shear = 0.2\n"), "did you mean \"share\"?"},
  };
  for (const auto& wrong : cases) {
    const SmallDie die;
    add_before_tools(die, wrong.tables);
    const Outcome outcome = die.check();
    EXPECT_EQ(outcome.exit_code, 2) << wrong.expected;
    EXPECT_NE(outcome.err.find(wrong.expected), std::string::npos) << outcome.err;
  }
}

/// A square channel uniform along z, in which powder falls for ever.
TEST(VerticalPeriod, LetsPowderFallForEverThroughAChannel) {
  const SmallDie die;
  die.write("die.stl",
            cad::binary_stl(cad::tube(cad::rectangle(-4, 4, -4, 4), cad::rectangle(-2, 2, -2, 2), -10, 10)));
  const std::string text = contents(die.scene());
  const std::size_t shoe = text.find("[[tool]]\nname = \"shoe\"");
  die.write("scene.toml",
            text.substr(0, shoe) +
                "[pour]\nfrom = [\"-1.9 mm\", \"-1.9 mm\", \"-8 mm\"]\nto = [\"1.9 mm\", \"1.9 mm\", "
                "\"8 mm\"]\nfill_height = \"1.5 mm\"\n\n[[step]]\nkind = \"wait\"\nduration = \"100 "
                "ms\"\n\n[numerics]\nperiodic = { z = \"16 mm\" }\nmax_time = \"100 ms\"\n");
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 4) << outcome.err;
  const auto result = results::read_results(die.out());
  EXPECT_EQ(result.powder.period[2], 16e-3);
  ASSERT_GT(result.powder.position.size(), 20U);
  EXPECT_EQ(die.report().at("grains_left").get<double>(), 0);
  double fall = 0;
  for (std::size_t k = 0; k < result.powder.position.size(); ++k) {
    // Grains return to the box when contacts are searched: at most a grain diameter beyond it.
    EXPECT_LE(std::abs(result.powder.position[k].z()), 8e-3 + result.powder.grain_diameter);
    fall -= result.powder.velocity[k].z() / static_cast<double>(result.powder.position.size());
  }
  EXPECT_GT(fall, 0.3) << "m/s after 0.1 s: slower than free fall, faster than rest";
}

}  // namespace
}  // namespace diefill::app
