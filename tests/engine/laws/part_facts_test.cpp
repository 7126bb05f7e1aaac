// What the parts say of themselves is true of what they do: history that changes sign, hysteresis, damping.
#include "engine/coarse_graining/general_contact_law.h"
#include "law_test_support.h"
#include "tests/engine/laws/source_laws.h"

namespace diefill::engine::laws {
namespace {

const PairProperties kPair = spheres(2.5e-4, 2.5e-4, 2500);

class PartFacts : public ::testing::TestWithParam<NamedLaw> {};

TEST_P(PartFacts, APairStoredTheOtherWayRoundGoesOnAsBefore) {
  const GeneralLaw law = make_law(GetParam().law, kPair);
  std::vector<double> history(GeneralLaw::kHistory), turned;
  ContactState state;
  state.normal = {0.6, 0, 0.8};
  state.time_step = state.rolling_step = 1e-7;
  for (int k = 1; k < 200; ++k) {
    state.overlap = 2e-6 * std::sin(0.02 * k) + 1e-8;
    state.velocity = {0.03, 0.05 * std::cos(0.1 * k), 0.01};
    state.spin = {20, -30.0 * std::sin(0.1 * k), 10};
    law.react(state, history.data());
  }
  turned = history;
  for (std::size_t k = 0; k < turned.size(); ++k) turned[k] *= GeneralLaw::kHistorySigns[k];
  ContactState other = state;
  other.normal = -1.0 * state.normal;
  other.velocity = -1.0 * state.velocity;
  other.spin = -1.0 * state.spin;
  const Reaction one = law.react(state, history.data()), two = law.react(other, turned.data());
  EXPECT_EQ(one.force.x, -two.force.x);
  EXPECT_EQ(one.force.y, -two.force.y);
  EXPECT_EQ(one.force.z, -two.force.z);
  EXPECT_EQ(one.torque.x, -two.torque.x);
  EXPECT_EQ(one.torque.y, -two.torque.y);
  EXPECT_EQ(one.torque.z, -two.torque.z);
  for (std::size_t k = 0; k < turned.size(); ++k)
    EXPECT_EQ(turned[k], GeneralLaw::kHistorySigns[k] * history[k]) << k;
}

TEST_P(PartFacts, OnlyAHystereticForceDependsOnThePast) {
  const GeneralLaw law = make_law({.normal = GetParam().law.normal}, kPair);
  std::vector<double> history(GeneralLaw::kHistory), fresh(GeneralLaw::kHistory);
  const double overlap = 1e-6, deep = 3e-6;
  law.normal.force(deep, std::sqrt(deep), history.data());
  const double later = law.normal.force(overlap, std::sqrt(overlap), history.data()).force;
  const double first = law.normal.force(overlap, std::sqrt(overlap), fresh.data()).force;
  EXPECT_EQ(law.normal.hysteretic(), later != first);
}

TEST_P(PartFacts, DampingIsTheForceOverTheSpeed) {
  const GeneralLaw law = make_law(GetParam().law, kPair);
  const double overlap = 1e-6, root = 1e-3;
  EXPECT_EQ(law.damping.damping(overlap, root), -law.damping.force(overlap, root, 1));
  EXPECT_EQ(GetParam().law.damping.dissipates(), law.damping.damping(overlap, root) > 0);
}

TEST_P(PartFacts, OnlyWhatAttractsPulls) {
  const GeneralLaw law = make_law(GetParam().law, kPair);
  std::vector<double> history(GeneralLaw::kHistory);
  ContactState state;
  state.normal = {0, 0, 1};
  bool pulls = false;
  for (double overlap = 3e-6; overlap > 0; overlap -= 1e-9) {
    state.overlap = overlap;
    pulls = pulls || law.react(state, history.data()).force.z < 0;
  }
  EXPECT_EQ(GetParam().law.attracts(), pulls);
}

INSTANTIATE_TEST_SUITE_P(Sources, PartFacts, ::testing::ValuesIn(laws_of_the_sources()), [](const auto& law) {
  std::string name = law.param.name;
  std::erase(name, ' ');
  return name;
});

}  // namespace
}  // namespace diefill::engine::laws
