// Every contact law that a scene can name, through the real program, from the scene file to the report.
#include <gtest/gtest.h>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

/// The tables of [contact] of one law, and the rule of coarse graining.
struct NamedLaws {
  std::string name;
  std::string contact;
  std::string scaling = "bierwisch";
};

std::ostream& operator<<(std::ostream& stream, const NamedLaws& laws) {
  return stream << laws.name;
}

constexpr const char* kHertz = "normal = { law = \"Hertz-Mindlin\", modulus = \"1.5 MPa\" }\n";
constexpr const char* kLuding =
    "normal = { law = \"Luding\", loading_stiffness = \"50 N/m\", unloading_stiffness = \"150 N/m\", "
    "cohesion_stiffness = \"5 N/m\" }\n";
constexpr const char* kBounce = "damping = { law = \"restitution\", restitution = 0.3 }\n";
constexpr const char* kLinearBounce = "damping = { law = \"linear restitution\", restitution = 0.3 }\n";
constexpr const char* kMindlin =
    "friction = { law = \"Mindlin\", friction = 0.4, shear_modulus = \"0.6 MPa\" }\n";

std::vector<NamedLaws> named_laws() {
  const std::string hertz = std::string(kHertz) + kBounce + kMindlin,
                    luding = std::string(kLuding) + kLinearBounce +
                             "friction = { law = \"Luding\", static_friction = 0.4, dynamic_friction = 0.3, "
                             "stiffness = \"30 N/m\" }\n";
  std::vector<NamedLaws> laws = {
      {"Bierwisch",
       "normal = { law = \"Bierwisch\" }\ndamping = { law = \"Bierwisch\" }\nfriction = { law = "
       "\"Bierwisch\" }\n"},
      {"JKR", "normal = { law = \"JKR\", modulus = \"1.5 MPa\", surface_energy = \"0.001 J/m^2\" }\n" +
                  std::string(kBounce) + kMindlin},
      {"linear",
       "normal = { law = \"linear\", stiffness = \"50 N/m\" }\ndamping = { law = \"constant\", "
       "coefficient = \"1e-3 N s/m\" }\n"},
      {"CDT", hertz + "rolling = { law = \"CDT\", rolling_friction = 0.1 }\n"},
      {"EPSD2", hertz + "rolling = { law = \"EPSD2\", rolling_friction = 0.1 }\n"},
      {"elastic CDT", luding + "rolling = { law = \"elastic CDT\", rolling_friction = 0.1 }\n"},
      {"Luding", luding + "rolling = { law = \"Luding\", rolling_friction = 0.1 }\n"},
      {"van der Waals",
       hertz + "attraction = { law = \"van der Waals\", hamaker_constant = \"6.5e-20 J\" }\n"},
      {"capillary", hertz + "attraction = { law = \"capillary\", surface_tension = \"0.001 N/m\" }\n"},
  };
  for (const char* method :
       {"none", "scaled-up particle", "Hu chapter 4 method 2", "Hu chapter 4 method 3",
        "Hu chapter 5 method 2", "Hu chapter 5 method 3", "Sakai-Koshizuka", "Chu", "Thakur"})
    laws.push_back({method, hertz, method});
  return laws;
}

/// Rotating spheres that fall a little into the small die's shoe, with the laws.
void set_up(const SmallDie& die, const NamedLaws& laws) {
  die.exchange("preset = \"ASC100.29 A2\"\n", "preset = \"ASC100.29 initial B\"\n");
  die.exchange("reduced_modulus = \"3 MPa\"\ndamping_over_radius = \"3e5 Pa s/m\"\n", "");
  die.exchange("[[tool]]\nname = \"die\"", "[contact]\ncoarse_graining = \"" + laws.scaling + "\"\n" +
                                               laws.contact + "\n[[tool]]\nname = \"die\"");
  die.exchange("fill_height = \"5 mm\"", "fill_height = \"1.2 mm\"");
  die.exchange("kind = \"passage\"\ntool = \"shoe\"\ndirection = \"-x\"\nvelocity = \"0.1 m/s\"",
               "kind = \"wait\"\nduration = \"1 ms\"");
}

class Laws : public testing::TestWithParam<NamedLaws> {};

TEST_P(Laws, RunEndToEndAndKeepTheirEnergy) {
  const SmallDie die;
  set_up(die, GetParam());
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto report = die.report();
  EXPECT_GT(report.at("grains").get<double>(), 20);
  EXPECT_EQ(report.at("grains_left").get<double>(), 0);
  EXPECT_LT(report.at("deepest_overlap_ratio").get<double>(), 0.2);
  EXPECT_LT(std::abs(report.at("energy_balance_error").get<double>()), 0.01);
}

INSTANTIATE_TEST_SUITE_P(All, Laws, testing::ValuesIn(named_laws()),
                         [](const auto& instance) { return "law" + std::to_string(instance.index); });

TEST(LawsInWords, AreNamedByCheckAndPlan) {
  const SmallDie die;
  set_up(die, named_laws().at(4));
  const std::string rolls = "rolling EPSD2 (rolling_friction 0.1, shear_modulus 600000 Pa)";
  EXPECT_NE(die.check().out.find(rolls), std::string::npos) << die.check().out;
  const Outcome plan = run_program({"plan", die.scene().string(), "--no-benchmark"});
  EXPECT_NE(plan.out.find(rolls), std::string::npos) << plan.out;
}

TEST(LawsInWords, OwnLawIsNamedByCheckToo) {
  const SmallDie die;
  EXPECT_NE(die.check().out.find("laws in use: Hertz repulsion"), std::string::npos) << die.check().out;
}

}  // namespace
}  // namespace diefill::app
