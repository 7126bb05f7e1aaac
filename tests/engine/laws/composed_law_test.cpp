// Laws put together: runtime choice against fixed parts, history, loads, and combinations that are refused.
#include "law_test_support.h"

namespace diefill::engine::laws {
namespace {

const PairProperties kPair = spheres(2.5e-4, 4e-4);
using FixedLaw =
    ComposedLaw<LudingNormal, LinearRestitutionDamping, LudingFriction, LudingRolling, VanDerWaals>;

LawParameters full_parameters() {
  LawParameters law{.normal = LudingNormal::Parameters{.loading = 150, .unloading = 600, .cohesion = 20}};
  law.damping = LinearRestitutionDamping::Parameters{.restitution = 0.65, .stiffness = 150};
  law.friction = LudingFriction::Parameters{
      .stiffness = 90, .damping = 1e-5, .static_friction = 0.7, .dynamic_friction = 0.5};
  law.rolling = LudingRolling::Parameters{.rolling_friction = 0.1, .time_step = 1e-8};
  law.attraction = VanDerWaals::Parameters{.hamaker = 5e-18};
  return law;
}

FixedLaw fixed_law(const LawParameters& given) {
  return {
      {*given.normal.of<LudingNormal>(), kPair},     {*given.damping.of<LinearRestitutionDamping>(), kPair},
      {*given.friction.of<LudingFriction>(), kPair}, {*given.rolling.of<LudingRolling>(), kPair},
      {*given.attraction.of<VanDerWaals>(), kPair},  given.load_rule};
}

/// A winding path through contact and out of it.
ContactState state_at(int step) {
  ContactState state;
  const double t = 0.01 * step;
  state.overlap = 2e-5 * std::sin(1.7 * t) + 1e-6 * std::sin(13 * t);
  state.normal = {std::sin(0.1 * t), 0, std::cos(0.1 * t)};
  state.velocity = {0.1 * std::sin(t), 0.05, 0.2 * std::cos(1.7 * t)};
  state.spin = {20 * std::cos(t), 3, -10};
  state.time_step = 1e-6;
  state.rolling_step = 1e-6;
  return state;
}

TEST(GeneralLawOfAnyParts, ReactsAsTheFixedLaw) {
  const auto parameters = full_parameters();
  require_sensible(parameters);
  const auto fixed = fixed_law(parameters);
  const auto general = make_law(parameters, kPair);
  std::vector<double> memory_fixed(FixedLaw::kHistory), memory_general(GeneralLaw::kHistory);
  EXPECT_EQ(general.range(), fixed.range());
  for (int step = 0; step < 2000; ++step) {
    const auto a = fixed.react(state_at(step), memory_fixed.data());
    const auto b = general.react(state_at(step), memory_general.data());
    ASSERT_EQ(length(a.force - b.force), 0) << step;
    ASSERT_EQ(length(a.torque - b.torque), 0) << step;
    ASSERT_EQ(a.load, b.load);
    ASSERT_EQ(a.normal_power + a.viscous_power + a.friction_power + a.rolling_power + a.attraction_power,
              b.normal_power + b.viscous_power + b.friction_power + b.rolling_power + b.attraction_power);
    const double overlap = state_at(step).overlap;
    ASSERT_EQ(fixed.contact_energy(overlap, memory_fixed.data()),
              general.contact_energy(overlap, memory_general.data()));
  }
}

TEST(ComposedLawHistory, HasRoomForTheLargestPartAndIsWipedApart) {
  EXPECT_EQ(FixedLaw::kHistory, 1 + 4 + 3 + 0);
  EXPECT_EQ(GeneralLaw::kHistory, 2 + 4 + 3 + 1);
  const auto law = make_law(full_parameters(), kPair);
  std::vector<double> history(GeneralLaw::kHistory);
  auto state = state_at(50);
  ASSERT_GT(state.overlap, 0);
  law.react(state, history.data());
  EXPECT_GT(history[0], 0);
  EXPECT_NE(history[GeneralLaw::kFrictionHistory], 0);
  EXPECT_NE(history[GeneralLaw::kRollingHistory], 0);
  state.overlap = 0;
  const auto apart = law.react(state, history.data());
  for (const double value : history) EXPECT_EQ(value, 0);
  EXPECT_EQ(length(apart.torque), 0);
  EXPECT_EQ(apart.load, 0);
  EXPECT_LT(dot(apart.force, state.normal), 0);  // van der Waals goes on
  EXPECT_LT(length(cross(apart.force, state.normal)), 1e-15 * length(apart.force));
}

TEST(ComposedLawHistory, KeepsTheBridgeWhileApart) {
  LawParameters parameters;
  parameters.attraction = CapillaryBridge::Parameters{.surface_tension = 0.07};
  const auto law = make_law(parameters, kPair);
  std::vector<double> history(GeneralLaw::kHistory);
  ContactState state;
  state.normal = {0, 0, 1};
  state.overlap = -1e-6;
  EXPECT_EQ(law.react(state, history.data()).force.z, 0);
  state.overlap = 1e-7;
  law.react(state, history.data());
  state.overlap = -1e-6;
  EXPECT_LT(law.react(state, history.data()).force.z, 0);
  EXPECT_LT(law.attraction_energy(state.overlap, history.data()), 0);
}

TEST(ComposedLawLoad, FollowsTheRule) {
  const double overlap = 1e-6, root = 1e-3;
  ContactState state;
  state.overlap = overlap;
  state.normal = {0, 0, 1};
  state.velocity = {0, 0, 50};  // separates so fast that damping outweighs the spring
  for (const auto rule : {LoadRule::with_damping, LoadRule::without, LoadRule::repulsive_only}) {
    LawParameters parameters{.normal = HertzMindlinNormal::Parameters{.modulus = 5e6}};
    parameters.damping = RestitutionDamping::Parameters{.restitution = 0.2, .modulus = 5e6};
    parameters.load_rule = rule;
    const auto law = make_law(parameters, kPair);
    std::vector<double> history(GeneralLaw::kHistory);
    const auto reaction = law.react(state, history.data());
    const double elastic = HertzMindlinNormal({.modulus = 5e6}, kPair).force(overlap, root, nullptr).force;
    ASSERT_LT(elastic + reaction.viscous, 0);
    EXPECT_NEAR(reaction.force.z, elastic + reaction.viscous, 1e-15);
    const double expected = rule == LoadRule::with_damping ? -(elastic + reaction.viscous)
                            : rule == LoadRule::without    ? elastic
                                                           : 0;
    EXPECT_NEAR(reaction.load, expected, 1e-15);
  }
}

TEST(ComposedLawLoad, OfLudingIsShiftedByTheCohesionStiffness) {
  LawParameters parameters{.normal =
                               LudingNormal::Parameters{.loading = 150, .unloading = 600, .cohesion = 20}};
  parameters.attraction = VanDerWaals::Parameters{.hamaker = 5e-18};
  const auto law = make_law(parameters, kPair);
  std::vector<double> history(GeneralLaw::kHistory);
  ContactState state;
  state.overlap = 1e-6;
  state.normal = {0, 0, 1};
  const auto reaction = law.react(state, history.data());
  EXPECT_NEAR(reaction.load, 170e-6, 1e-18);  // van der Waals left out (Kottlan 2018, Eq. 18)
  EXPECT_NEAR(reaction.force.z, 150e-6 + reaction.attraction, 1e-18);
  EXPECT_LT(reaction.attraction, 0);
}

struct Refusal {
  LawParameters law;
  std::string word;
};

TEST(LawCombinations, ThatMakeNoSenseAreRefusedWithAReason) {
  const auto jkr = JkrNormal::Parameters{.modulus = 5e6, .surface_energy = 0.1};
  const auto hertz = HertzMindlinNormal::Parameters{.modulus = 5e6};
  const auto spring = LinearNormal::Parameters{.stiffness = 150};
  const auto waals = VanDerWaals::Parameters{.hamaker = 1e-19};
  const std::vector<Refusal> refusals = {
      {{.normal = jkr, .attraction = waals}, "adhesion"},
      {{.normal = BierwischNormal::Parameters{.work_of_adhesion = 0.1}, .attraction = waals}, "adhesion"},
      {{.normal = hertz, .damping = LinearRestitutionDamping::Parameters{.stiffness = 150}}, "k_1"},
      {{.normal = spring, .damping = LinearRestitutionDamping::Parameters{.stiffness = 151}}, "same value"},
      {{.normal = spring, .damping = RestitutionDamping::Parameters{.modulus = 5e6}}, "E*"},
      {{.normal = hertz, .damping = RestitutionDamping::Parameters{.modulus = 6e6}}, "same value"},
      {{.normal = hertz, .rolling = ElasticRolling::Parameters{.stiffness = 150}}, "k_1"},
      {{.normal = hertz, .damping = RestitutionDamping::Parameters{.restitution = 1.2, .modulus = 5e6}},
       "1.2"},
      {{.normal = LudingNormal::Parameters{.loading = 600, .unloading = 600}}, "linear spring"},
      {{.normal = LinearNormal::Parameters{.stiffness = std::nan("")}}, "nan"},
      {{.normal = spring,
        .friction = LudingFriction::Parameters{.static_friction = 0.2, .dynamic_friction = 0.3}},
       "dynamic friction"},
      {{.normal = spring, .attraction = VanDerWaals::Parameters{.smallest_gap = 1e-6, .largest_gap = 1e-7}},
       "largest gap"},
  };
  for (const auto& refusal : refusals) try {
      require_sensible(refusal.law);
      ADD_FAILURE() << "not refused: " << refusal.word;
    } catch (const std::invalid_argument& reason) {
      EXPECT_NE(std::string(reason.what()).find(refusal.word), std::string::npos) << reason.what();
    }
}

TEST(LawCombinations, ThatMakeSenseAreTaken) {
  const auto jkr = JkrNormal::Parameters{.modulus = 5e6, .surface_energy = 0.1};
  EXPECT_NO_THROW(require_sensible({}));
  EXPECT_NO_THROW(require_sensible(full_parameters()));
  EXPECT_NO_THROW(require_sensible({.normal = jkr, .attraction = CapillaryBridge::Parameters{}}));
  EXPECT_NO_THROW(require_sensible({.normal = BierwischNormal::Parameters{.reduced_modulus = 1e7},
                                    .damping = RestitutionDamping::Parameters{.modulus = 5e6},
                                    .attraction = VanDerWaals::Parameters{}}));
  EXPECT_NO_THROW(require_sensible({.normal = jkr, .friction = LudingFriction::Parameters{}}));
}

TEST(LawsOfMaterials, AreFoundInEitherOrder) {
  const std::vector<MaterialPairLaw> laws = {{"powder", "powder", {}},
                                             {"powder", "steel", {.load_rule = LoadRule::without}}};
  EXPECT_EQ(law_between(laws, "steel", "powder").load_rule, LoadRule::without);
  EXPECT_EQ(law_between(laws, "powder", "powder").load_rule, LoadRule::with_damping);
  EXPECT_THROW(law_between(laws, "steel", "glass"), std::invalid_argument);
}

}  // namespace
}  // namespace diefill::engine::laws
