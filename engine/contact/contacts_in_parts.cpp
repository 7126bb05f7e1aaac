#include "engine/contact/contacts_in_parts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

#include "engine/coarse_graining/general_contact_law.h"
#include "engine/contact/contact_batch.h"

namespace diefill::engine {

namespace {

using laws::GeneralContactLaw;
using laws::GeneralLaw;
using Batch = ContactBatch<GeneralContactLaw>;

/// The same part in all lanes. A copy, which no store to the batch can change: its numbers stay in registers.
template <class Part>
class OnePart {
 public:
  template <class PartOf>
  OnePart(const Batch& batch, const PartOf& part) : part_(part(*batch.law[0])) {}
  const Part& operator[](std::size_t) const { return part_; }

 private:
  const Part part_;
};

/// A part in every lane, number by number: loops that gather them from where laws are kept do not vectorise.
template <class Part>
class PartOfLane {
 public:
  template <class PartOf>
  PartOfLane(const Batch& batch, const PartOf& part) {
    for (std::size_t lane = 0; lane < whole_groups(batch.count); ++lane) {
      double numbers[kNumbers];
      std::memcpy(numbers, &part(*batch.law[lane]), sizeof(Part));
      for (std::size_t k = 0; k < kNumbers; ++k) numbers_[k][lane] = numbers[k];
    }
  }
  Part operator[](std::size_t lane) const {
    std::array<double, kNumbers> numbers;
    for (std::size_t k = 0; k < kNumbers; ++k) numbers[k] = numbers_[k][lane];
    return std::bit_cast<Part>(numbers);
  }

 private:
  static constexpr std::size_t kNumbers = sizeof(Part) / sizeof(double);
  Lanes<Batch::kLanes> numbers_[kNumbers];
};

/// Lets a part act on every lane.
template <class Parts, class Act>
void act_on_lanes(Batch& batch, const Parts& part, const Act& act) {
  const laws::Load load = batch.law[0]->parts().load;
  const std::size_t lanes = whole_groups(batch.count);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    laws::ContactInParts contact = batch.parts[lane];
    batch.change_history(lane, [&](double* history) { act(load, part[lane], contact, history); });
    batch.parts.set(lane, contact);
  }
}

laws::ContactState state_of(const Batch& batch, std::size_t lane, double time_step) {
  laws::ContactState state;
  state.overlap = batch.overlap[lane];
  state.normal = batch.normal[lane];
  state.velocity = batch.velocity[lane];
  state.spin = batch.relative_spin[lane];
  state.time_step = state.rolling_step = time_step;
  return state;
}

void begin(Batch& batch, const GeneralContactLaw& law, double time_step) {
  const std::size_t lanes = whole_groups(batch.count);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane)
    batch.parts.set(lane, laws::ContactInParts(law.original(state_of(batch, lane, time_step))));
}

void sum_up(Batch& batch, const GeneralContactLaw& law) {
  const std::size_t lanes = whole_groups(batch.count);
#pragma GCC ivdep
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    laws::Reaction reaction;
    batch.change_history(lane,
                         [&](double* history) { reaction = GeneralLaw::sum(batch.parts[lane], history); });
    batch.put(lane, law.scaled(reaction, batch.normal[lane]));
  }
}

/// Where all laws differ in their parts' numbers only, or, `kOneLaw`, not at all.
template <bool kOneLaw>
void react_together(Batch& batch, double time_step) {
  const GeneralContactLaw& law = *batch.law[0];
  begin(batch, law, time_step);
  GeneralLaw::for_each_part([&](auto member, const auto& act) {
    (law.parts().*member).with([&]<class Part>(const Part&) {
      using Parts = std::conditional_t<kOneLaw || std::is_empty_v<Part>, OnePart<Part>, PartOfLane<Part>>;
      const auto part = [member](const GeneralContactLaw& of) -> const Part& {
        return (of.parts().*member).template as<Part>();
      };
      act_on_lanes(batch, Parts(batch, part), act);
    });
  });
  sum_up(batch, law);
}

/// Where lanes have laws of different parts.
void react_one_by_one(Batch& batch, double time_step) {
  for (std::size_t lane = 0; lane < whole_groups(batch.count); ++lane)
    batch.change_history(lane, [&](double* history) {
      batch.put(lane, batch.law[lane]->react(state_of(batch, lane, time_step), history));
    });
}

}  // namespace

void react_by_parts(Batch& batch, InstructionSet instructions, double time_step) {
  const GeneralContactLaw& first = *batch.law[0];
  const auto all = [&](const auto& like_first) {
    return std::all_of(batch.law, batch.law + whole_groups(batch.count), like_first);
  };
  if (all([&](const auto* law) { return law == &first; }))
    with_instructions(instructions, [&] { react_together<true>(batch, time_step); });
  else if (all([&](const auto* law) { return law->form() == first.form(); }))
    with_instructions(instructions, [&] { react_together<false>(batch, time_step); });
  else
    react_one_by_one(batch, time_step);
}

}  // namespace diefill::engine
