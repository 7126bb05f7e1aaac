// What one description of contact makes sayable, through the real program: laws beside mirror planes, mesh
// walls, suction, several sizes; a contact of one tool; changes while the scene runs; clumps of the user's
// own.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <thread>

#include "process/results/storage/result_file.h"
#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

constexpr const char* kHertz =
    "[contact]\nnormal = { law = \"Hertz-Mindlin\", modulus = \"1.5 MPa\" }\n"
    "damping = { law = \"restitution\", restitution = 0.3 }\n"
    "friction = { law = \"Mindlin\", friction = 0.4, shear_modulus = \"0.6 MPa\" }\n\n[pour]";
constexpr const char* kTwoSizes =
    "sizes = { distribution = \"classes\", classes = [{ diameter = \"0.8 mm\", share = 0.5 }, { diameter = "
    "\"1.1 mm\", share = 0.5 }] }\n";
constexpr const char* kSize = "grain_diameter = \"1 mm\"\n";

/// The laws of kHertz with `more` parts, in place of the powder's own.
void take_hertz(const SmallDie& die, const std::string& more = "") {
  std::string contact = kHertz;
  contact.insert(contact.find("\n[pour]"), more);
  die.exchange("[pour]", contact);
  die.exchange("reduced_modulus = \"3 MPa\"\ndamping_over_radius = \"3e5 Pa s/m\"\n", "");
}

/// The report of a run that must be whole: every grain accounted for, energy balanced.
nlohmann::json whole_report(const SmallDie& die) {
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  if (outcome.exit_code != 0) return {};
  auto report = die.report();
  EXPECT_LT(std::abs(report.at("energy_balance_error").get<double>()), 0.02);
  EXPECT_GT(report.at("filled_mass_kg").get<double>(), 0);
  return report;
}

TEST(Contact, LawsGoWithTheMirrorPlane) {
  for (const char* attraction :
       {"", "attraction = { law = \"van der Waals\", hamaker_constant = \"6.5e-20 J\" }\n"}) {
    const SmallDie whole, half;
    for (const SmallDie* die : {&whole, &half}) {
      take_hertz(*die, attraction);
      die->exchange(kSize, "grain_diameter = \"0.8 mm\"\n");
    }
    half.exchange("[numerics]", "[economy]\nmirror = \"y\"\n\n[numerics]");
    const auto all = whole_report(whole), mirrored = whole_report(half);
    EXPECT_NEAR(mirrored.at("filled_mass_kg").get<double>(), all.at("filled_mass_kg").get<double>(),
                0.35 * all.at("filled_mass_kg").get<double>());
  }
}

TEST(Contact, SeveralSizesGoWithMeshWallsMirrorAndSettings) {
  const SmallDie mesh, half;
  for (const SmallDie* die : {&mesh, &half}) die->exchange(kSize, kTwoSizes);
  mesh.exchange("sphere_radius = \"0.25 mm\"", "sphere_radius = \"0.25 mm\"\nkind = \"mesh\"");
  half.exchange("[numerics]", "[economy]\nmirror = \"y\"\n\n[numerics]");
  for (const SmallDie* die : {&mesh, &half}) {
    whole_report(*die);
    EXPECT_EQ(results::read_results(die->out()).powder.kinds.size(), 2U);
  }
  const SmallDie chosen;
  chosen.exchange(kSize, kTwoSizes);
  const Outcome planned = run_program({"check", chosen.scene().string(), "--setting", "quick"});
  EXPECT_EQ(planned.exit_code, 0) << planned.err;
}

TEST(Contact, SeveralSizesRollWithTheFrictionOfModelB) {
  const SmallDie die;
  die.exchange("preset = \"ASC100.29 A2\"\n", "preset = \"ASC100.29 initial B\"\n");
  die.exchange(kSize, kTwoSizes);
  const auto report = whole_report(die);
  const SmallDie smooth;
  smooth.exchange("preset = \"ASC100.29 A2\"\n",
                  "preset = \"ASC100.29 initial B\"\nrolling_friction = \"0 mm\"\n");
  smooth.exchange(kSize, kTwoSizes);
  EXPECT_NE(whole_report(smooth).at("state_hash"), report.at("state_hash")) << "rolling friction counts";
}

TEST(Contact, OfOneToolStandsBesideThatOfAll) {
  const SmallDie usual, slippery;
  for (const SmallDie* die : {&usual, &slippery}) take_hertz(*die);
  slippery.exchange("file = \"shoe.stl\"",
                    "file = \"shoe.stl\"\ncontact = { friction = { law = \"none\" } }");
  const auto one = whole_report(usual), other = whole_report(slippery);
  EXPECT_NE(one.at("state_hash"), other.at("state_hash"));
}

TEST(Contact, BierwischsPartsAreTheLawOfThePowderBitForBit) {
  const SmallDie own, named;
  named.exchange(
      "[pour]",
      "[contact]\nnormal = { law = \"Bierwisch\" }\ndamping = { law = \"Bierwisch\" }\nfriction = { law "
      "= \"Bierwisch\" }\n\n[pour]");
  EXPECT_EQ(whole_report(own).at("state_hash"), whole_report(named).at("state_hash"));
}

/// Clumps of three unequal spheres, in the scene or in a file.
constexpr const char* kClump =
    "spheres = [{ centre = [\"0 mm\", \"0 mm\", \"0 mm\"], radius = \"0.1 mm\" }, { centre = [\"0.12 mm\", "
    "\"0 "
    "mm\", \"0 mm\"], radius = \"0.07 mm\" }, { centre = [\"0 mm\", \"0.1 mm\", \"0 mm\"], radius = \"0.06 "
    "mm\" "
    "}]\ngrain_diameter = \"0.9 mm\"\n";

TEST(Clumps, OfTheUsersOwnFillAndAreDrawn) {
  const SmallDie die, from_file;
  die.exchange(kSize, kClump);
  from_file.write("grain.csv",
                  "x [mm], y [mm], z [mm], radius [mm]\n0, 0, 0, 0.1\n0.12, 0, 0, 0.07\n0, 0.1, 0, 0.06\n");
  from_file.exchange(kSize, "spheres_file = \"grain.csv\"\ngrain_diameter = \"0.9 mm\"\n");
  for (const SmallDie* each : {&die, &from_file})
    each->exchange("fill_height = \"5 mm\"", "fill_height = \"2 mm\"");
  const auto report = whole_report(die);
  const auto result = results::read_results(die.out());
  EXPECT_EQ(result.powder.sphere_offsets.size(), 3U);
  ASSERT_EQ(result.powder.sphere_radii.size(), 3U);
  EXPECT_NEAR(result.powder.sphere_radii[0] / result.powder.sphere_radii[2], 0.1 / 0.06, 1e-9);
  EXPECT_EQ(whole_report(from_file).at("state_hash"), report.at("state_hash"));
  const Outcome drawn = run_program(
      {"map", die.out().string(), "--picture", "view", "--out", (die.folder() / "maps").string()});
  EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
}

/// Centres that stand where no other sphere's mirror image across y = 0 does, m.
double farthest_from_an_image(const std::vector<Eigen::Vector3d>& centres) {
  double farthest = 0;
  for (const auto& centre : centres) {
    const Eigen::Vector3d image(centre.x(), -centre.y(), centre.z());
    double nearest = 1;
    for (const auto& other : centres) nearest = std::min(nearest, (other - image).norm());
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

TEST(Clumps, AreMirroredSphereBySphere) {
  const SmallDie die;
  die.exchange(kSize, kClump);
  die.exchange("[numerics]", "[economy]\nmirror = \"y\"\n\n[numerics]");
  whole_report(die);
  const auto centres = results::read_results(die.out()).powder.sphere_centres();
  ASSERT_GT(centres.size(), 100U);
  EXPECT_LT(farthest_from_an_image(centres), 1e-9);
}

TEST(Clumps, WithoutAMirrorPlaneOfTheirOwnAreNotMirrored) {
  const SmallDie die;
  std::string chiral = kClump;
  chiral.insert(chiral.find(" }]"),
                " }, { centre = [\"0.02 mm\", \"0.03 mm\", \"0.09 mm\"], radius = \"0.05 mm\"");
  die.exchange(kSize, chiral);
  die.exchange("[numerics]", "[economy]\nmirror = \"y\"\n\n[numerics]");
  const Outcome outcome = die.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("its mirror image, another grain"), std::string::npos) << outcome.err;
}

TEST(Clumps, ThatMakeNoSenseAreRefused) {
  const SmallDie die;
  die.exchange(kSize, std::string("spheres_file = \"grain.csv\"\n") + kSize);
  die.write("grain.csv", "x, y, z, radius\n0, 0, 0, 1\n");
  EXPECT_NE(die.check().err.find("found column \"x\" without a unit, allowed: x, y, z and radius"),
            std::string::npos);
  die.write("grain.csv", "x [mm], y [mm], z [mm], radius [mm]\n0, 0, 0.1\n");
  const Outcome outcome = die.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("grain.csv:2: found 3 values, expected 4"), std::string::npos) << outcome.err;
}

constexpr const char* kChanges =
    "[[step]]\nkind = \"settle\"\n\n[[step]]\nkind = \"change\"\ngravity = [\"2 m/s^2\", \"0 m/s^2\", \"-12 "
    "m/s^2\"]\nfriction = 0.6\nwall_friction = 0.1\nrandom_velocity = \"0.2 m/s\"\n\n[[step]]\nkind = "
    "\"wait\"\nduration = \"60 ms\"\n";

TEST(Change, OfGravityLawsAndVelocitiesEndsAsTheUnbrokenRunAfterAKill) {
  const SmallDie die, other, unchanged;
  for (const SmallDie* each : {&die, &other}) each->exchange_passage(kChanges);
  unchanged.exchange_passage(
      "[[step]]\nkind = \"settle\"\n\n[[step]]\nkind = \"wait\"\nduration = \"60 ms\"\n");
  const Outcome whole = other.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  ASSERT_EQ(unchanged.run({"--quiet", "--no-pictures"}).exit_code, 0);
  EXPECT_NE(other.report().at("state_hash"), unchanged.report().at("state_hash"));
  EXPECT_LT(std::abs(other.report().at("energy_balance_error").get<double>()), 0.02);
  for (int kills = 0; kills < 3; ++kills) {
    auto arguments = die.run_arguments({"--quiet", "--no-pictures"});
    if (kills > 0) arguments.push_back("--resume");
    Program program(arguments);
    std::this_thread::sleep_for(std::chrono::milliseconds(400 + 300 * kills));
    if (program.running()) program.send(SIGKILL);
    program.wait();
  }
  ASSERT_EQ(die.run({"--quiet", "--no-pictures", "--resume"}).exit_code, 0);
  EXPECT_EQ(die.report().at("state_hash"), other.report().at("state_hash"));
}

TEST(Change, OfGravityAcrossTheMirrorPlaneIsRefused) {
  const SmallDie die;
  die.exchange_passage(kChanges);
  die.exchange("[numerics]", "[economy]\nmirror = \"x\"\n\n[numerics]");
  const Outcome outcome = die.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("has a component across the mirror plane"), std::string::npos) << outcome.err;
}

TEST(Change, OfNothingIsRefused) {
  const SmallDie die;
  die.exchange_passage("[[step]]\nkind = \"change\"\n");
  const Outcome outcome = die.check();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("this step changes nothing"), std::string::npos) << outcome.err;
  const SmallDie smooth;
  smooth.exchange("[pour]",
                  "[contact]\nnormal = { law = \"Hertz-Mindlin\", modulus = \"1.5 MPa\" }\n\n[pour]");
  smooth.exchange("reduced_modulus = \"3 MPa\"\ndamping_over_radius = \"3e5 Pa s/m\"\n", "");
  smooth.exchange_passage("[[step]]\nkind = \"change\"\nfriction = 0.5\n");
  const Outcome refused = smooth.check();
  EXPECT_NE(refused.err.find("the law in use has no such coefficient"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace diefill::app
