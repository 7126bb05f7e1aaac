// Contacts between the parts of a law, one lane each: every part acts on many of them before the next one
// does.
#pragma once

#include "engine/laws/composed_law.h"
#include "engine/numerics/lanes.h"
#include "engine/numerics/vector_instructions.h"

namespace diefill::engine {

/// As laws::ContactInParts, which says what the numbers are.
template <std::size_t kCount>
class ContactsInParts {
 public:
  laws::ContactInParts operator[](std::size_t lane) const {
    laws::ContactInParts contact;
    contact.overlap = overlap_[lane];
    contact.root_overlap = root_overlap_[lane];
    contact.separation_speed = separation_speed_[lane];
    contact.normal = normal_[lane];
    contact.sliding = sliding_[lane];
    contact.spin = spin_[lane];
    contact.time_step = time_step_[lane];
    contact.rolling_step = rolling_step_[lane];
    contact.attraction = attraction_[lane];
    contact.static_normal = {static_force_[lane], static_limit_[lane]};
    contact.viscous = viscous_[lane];
    contact.load = load_[lane];
    contact.tangential = tangential_[lane];
    contact.torque = torque_[lane];
    return contact;
  }
  void set(std::size_t lane, const laws::ContactInParts& contact) {
    overlap_[lane] = contact.overlap;
    root_overlap_[lane] = contact.root_overlap;
    separation_speed_[lane] = contact.separation_speed;
    normal_.set(lane, contact.normal);
    sliding_.set(lane, contact.sliding);
    spin_.set(lane, contact.spin);
    time_step_[lane] = contact.time_step;
    rolling_step_[lane] = contact.rolling_step;
    attraction_[lane] = contact.attraction;
    static_force_[lane] = contact.static_normal.force;
    static_limit_[lane] = contact.static_normal.limit;
    viscous_[lane] = contact.viscous;
    load_[lane] = contact.load;
    tangential_.set(lane, contact.tangential);
    torque_.set(lane, contact.torque);
  }

 private:
  using Scalars = Lanes<kCount>;
  using Vectors = VectorLanes<kCount>;

  Scalars overlap_, root_overlap_, separation_speed_;
  Vectors normal_, sliding_, spin_;
  Scalars time_step_, rolling_step_, attraction_, static_force_, static_limit_, viscous_, load_;
  Vectors tangential_, torque_;
};

template <class Law>
struct ContactBatch;
namespace laws {
class GeneralContactLaw;
}

/// Forces and torques of all lanes by the law that each names, parts one after the other over all lanes. In:
/// overlap, normal, velocity where surfaces touch, relative spin and history; out: force, torque, load,
/// powers and history, with the bits of GeneralContactLaw::react().
void react_by_parts(ContactBatch<laws::GeneralContactLaw>& batch, InstructionSet instructions,
                    double time_step);

}  // namespace diefill::engine
