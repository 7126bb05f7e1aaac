// Many contacts at a time get from the parts of their laws, bit for bit, what each gets from react() alone.
#include "engine/contact/contacts_in_parts.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <vector>

#include "engine/coarse_graining/general_contact_law.h"
#include "engine/coarse_graining/methods.h"
#include "engine/contact/contact_batch.h"
#include "tests/engine/laws/source_laws.h"

namespace diefill::engine {
namespace {

using laws::GeneralContactLaw;
using Batch = ContactBatch<GeneralContactLaw>;

constexpr double kTimeStep = 1e-7;
constexpr std::size_t kContacts = 43;  // not a whole number of groups

GeneralContactLaw law_of(const laws::LawParameters& parameters, double radius,
                         const coarse_graining::ForceScaling& scaling = {}) {
  const double mass = 1e4 * radius * radius * radius;
  return {parameters, scaling, {radius, 1.3 * radius, mass, 2.2 * mass}};
}

std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets = {InstructionSet::baseline};
  if (best_instruction_set() != InstructionSet::baseline) sets.push_back(InstructionSet::avx2);
  if (best_instruction_set() == InstructionSet::avx512) sets.push_back(InstructionSet::avx512);
  return sets;
}

/// One contact by itself.
struct Alone {
  laws::ContactState state;
  std::vector<double> history;
  laws::Reaction reaction;
};

/// Contacts that come and go: overlaps of up to some micrometres, gaps up to as many.
class Contacts {
 public:
  explicit Contacts(std::vector<const GeneralContactLaw*> laws) : laws_(std::move(laws)) {
    batch_->count = laws_.size();
    for (auto& contact : alone_) contact.history.assign(Batch::kHistory, 0.0);
    for (auto& numbers : batch_->history)
      for (double& number : numbers.value) number = 0;
  }
  void step(InstructionSet instructions) {
    move();
    react_by_parts(*batch_, instructions, kTimeStep);
    for (std::size_t lane = 0; lane < laws_.size(); ++lane)
      alone_[lane].reaction = laws_[lane]->react(alone_[lane].state, alone_[lane].history.data());
  }
  void expect_the_same() const {
    for (std::size_t lane = 0; lane < laws_.size(); ++lane) {
      const auto& [state, history, reaction] = alone_[lane];
      for (const auto& [here, there] :
           {std::pair{batch_->force[lane], reaction.force}, {batch_->torque[lane], reaction.torque}}) {
        EXPECT_EQ(here.x, there.x);
        EXPECT_EQ(here.y, there.y);
        EXPECT_EQ(here.z, there.z);
      }
      EXPECT_EQ(batch_->load[lane], reaction.load);
      EXPECT_EQ(batch_->viscous_power[lane], reaction.viscous_power);
      EXPECT_EQ(batch_->friction_power[lane], reaction.friction_power);
      EXPECT_EQ(batch_->rolling_power[lane], reaction.rolling_power);
      for (std::size_t k = 0; k < Batch::kHistory; ++k) EXPECT_EQ(batch_->history[k][lane], history[k]);
    }
  }
  /// Of all lanes.
  int pushed() const {
    int pushed = 0;
    for (const auto& contact : alone_) pushed += length(contact.reaction.force) > 0;
    return pushed;
  }

 private:
  Vector3 random_vector(double size) {
    return {size * number_(random_), size * number_(random_), size * number_(random_)};
  }
  void move() {
    for (std::size_t lane = 0; lane < whole_groups(laws_.size()); ++lane) {
      const std::size_t one = std::min(lane, laws_.size() - 1);
      laws::ContactState& state = alone_[one].state;
      if (lane == one) {
        const Vector3 way = random_vector(1);
        state.overlap = 5e-6 * number_(random_);
        state.normal = 1 / length(way) * way;
        state.velocity = random_vector(0.2);
        state.spin = random_vector(300);
        state.time_step = state.rolling_step = kTimeStep;
      }
      batch_->overlap[lane] = state.overlap;
      batch_->normal.set(lane, state.normal);
      batch_->velocity.set(lane, state.velocity);
      batch_->relative_spin.set(lane, state.spin);
      batch_->law[lane] = laws_[one];
    }
  }

  std::vector<const GeneralContactLaw*> laws_;
  std::unique_ptr<Batch> batch_ = std::make_unique<Batch>();
  std::vector<Alone> alone_{laws_.size()};
  std::mt19937_64 random_{7};
  std::uniform_real_distribution<double> number_{-1, 1};
};

/// `few` laws, dealt out to the lanes in turn.
void expect_parts_agree(const std::vector<GeneralContactLaw>& few, const std::string& what) {
  for (const auto instructions : instruction_sets()) {
    SCOPED_TRACE(what + ", instruction set " + std::to_string(static_cast<int>(instructions)));
    std::vector<const GeneralContactLaw*> laws;
    for (std::size_t lane = 0; lane < kContacts; ++lane) laws.push_back(&few[lane % few.size()]);
    Contacts contacts(laws);
    for (int step = 0; step < 20; ++step) {
      contacts.step(instructions);
      contacts.expect_the_same();
      if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(contacts.pushed(), 10);
    EXPECT_LE(contacts.pushed(), static_cast<int>(kContacts));
  }
}

TEST(ContactsInParts, ReactAsEachAloneWhereAllHaveOneLaw) {
  for (const auto& [law, method, scale] : laws::laws_under({"scaled-up particle", "Chu"}))
    expect_parts_agree({law_of(law.law, scale * 2.5e-4, coarse_graining::force_scaling(method, scale))},
                       law.name + " under " + method);
}

TEST(ContactsInParts, ReactAsEachAloneWhereRadiiDiffer) {
  for (const auto& [name, law] : laws::laws_of_the_sources())
    expect_parts_agree({law_of(law, 2e-4), law_of(law, 2.5e-4), law_of(law, 4e-4)}, name);
}

TEST(ContactsInParts, ReactAsEachAloneWhereLawsAreOfDifferentParts) {
  std::vector<GeneralContactLaw> all;
  for (const auto& [name, law] : laws::laws_of_the_sources()) all.push_back(law_of(law, 2.5e-4));
  expect_parts_agree(all, "all laws of the sources");
}

TEST(ContactsInParts, TellApartHowTheLoadIsMade) {
  laws::LawParameters damped = laws::laws_of_the_sources().front().law, undamped = damped, repulsive = damped;
  undamped.load_rule = laws::LoadRule::without;
  repulsive.load_rule = laws::LoadRule::repulsive_only;
  const GeneralContactLaw one = law_of(damped, 2.5e-4), other = law_of(undamped, 2.5e-4),
                          third = law_of(repulsive, 2.5e-4);
  EXPECT_NE(one.form(), other.form());
  EXPECT_NE(one.form(), third.form());
  EXPECT_NE(other.form(), third.form());
  EXPECT_EQ(one.form(), law_of(damped, 3e-4).form());
  expect_parts_agree({one, other, third}, "three rules of load");
}

}  // namespace
}  // namespace diefill::engine
