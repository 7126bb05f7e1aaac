// A contact law composed of one part of each kind: relative motion in, force and torque out. Grains, walls,
// the engine and the slow reference evaluate the parts in the order that `for_each_part` defines.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "engine/laws/parts.h"
#include "engine/laws/reaction.h"

namespace diefill::engine::laws {

/// How the load in the limits of friction and rolling follows from the normal part's limit and damping.
enum class LoadRule {
  with_damping,   ///< |limit + viscous| (Bierwisch 2009, Eqs. 2.7, 2.11; Hu 2024 for Hertz; Kottlan 2018)
  without,        ///< |limit| (Hu 2024 for JKR)
  repulsive_only  ///< max(0, limit + viscous)
};

/// The rule as numbers: loops with a branch do not vectorise.
class Load {
 public:
  Load(LoadRule rule = LoadRule::with_damping)  // NOLINT: a rule is all that a load needs
      : viscous_share_(rule == LoadRule::without ? 0 : 1),
        pull_share_(rule == LoadRule::repulsive_only ? 0 : -1) {}
  /// N, of the normal part's limit and the damping's force (N).
  double of(double limit, double viscous) const {
    const double sum = limit + viscous_share_ * viscous;
    return sum >= 0 ? sum : pull_share_ * sum;
  }
  /// A number that distinguishes the rules.
  std::uint32_t form() const { return static_cast<std::uint32_t>(2 * viscous_share_ - pull_share_); }

 private:
  double viscous_share_, pull_share_;
};

/// A contact while the parts of a law act on it.
struct ContactInParts {
  double overlap = 0;                      ///< m, positive in contact, minus the gap otherwise
  double root_overlap = 0;                 ///< m^(1/2), 0 apart
  double separation_speed = 0;             ///< m/s
  Vector3 normal = {};                     ///< from j to i
  Vector3 sliding = {};                    ///< m/s, across the normal
  Vector3 spin = {};                       ///< rad/s, omega_i - omega_j
  double time_step = 0, rolling_step = 0;  ///< s

  double attraction = 0;  ///< N, of the distant part
  StaticForce static_normal = {};
  double viscous = 0, load = 0;          ///< N
  Vector3 tangential = {}, torque = {};  ///< N and N m, on i

  ContactInParts() = default;
  explicit ContactInParts(const ContactState& state)
      : overlap(state.overlap),
        root_overlap(std::sqrt(state.overlap > 0 ? state.overlap : 0.0)),
        separation_speed(dot(state.velocity, state.normal)),
        normal(state.normal),
        sliding(state.velocity - separation_speed * state.normal),
        spin(state.spin),
        time_step(state.time_step),
        rolling_step(state.rolling_step) {}
};

template <NormalPart Normal, DampingPart Damping, FrictionPart Friction, RollingPart Rolling,
          AttractionPart Attraction>
struct ComposedLaw {
  // History of a pair: part after part, the attraction's last because it outlives the contact.
  static constexpr int kFrictionHistory = Normal::kHistory;
  static constexpr int kRollingHistory = kFrictionHistory + Friction::kHistory;
  static constexpr int kAttractionHistory = kRollingHistory + Rolling::kHistory;
  static constexpr int kHistory = kAttractionHistory + Attraction::kHistory;
  /// As in parts.h, of all parts. Numbers that no part uses keep their sign.
  static constexpr HistorySigns<static_cast<std::size_t>(kHistory)> kHistorySigns = [] {
    HistorySigns<static_cast<std::size_t>(kHistory)> signs = {};
    std::size_t place = 0;
    const auto append = [&](const auto& of_part) {
      for (const double sign : of_part) signs[place++] = sign != 0 ? sign : 1;
    };
    append(Normal::kHistorySigns), append(Friction::kHistorySigns);
    append(Rolling::kHistorySigns), append(Attraction::kHistorySigns);
    return signs;
  }();

  Normal normal;
  Damping damping;
  Friction friction;
  Rolling rolling;
  Attraction attraction;
  Load load = {};

  /// m, the largest gap at which the pair must still be considered.
  double range() const { return attraction.range(); }

  /// Number that identifies the parts and the rule for the load: laws of one form differ only in numbers. For
  /// laws whose parts are selected at run time.
  std::uint32_t form() const {
    std::uint32_t form = load.form();
    for (const std::size_t place :
         {normal.which(), damping.which(), friction.which(), rolling.which(), attraction.which()})
      form = 16 * form + static_cast<std::uint32_t>(place);
    return form;
  }

  /// What each number of the history means, 0 for none: laws that give a number the same meaning can go on
  /// with each other's. For laws whose parts are selected at run time.
  std::vector<std::uint32_t> history_layout() const {
    std::vector<std::uint32_t> layout;
    const auto append = [&]<class Part>(const Part& part) {
      for (int k = 0; k < Part::kHistory; ++k) layout.push_back(part.history_meaning(k));
    };
    append(normal), append(friction), append(rolling), append(attraction);
    return layout;
  }

  /// Force and torque at `state`; advances the pair's `history` (kHistory doubles) by one time step, so call
  /// it once per pair and step. Without contact only the attraction acts, and the history of the contact is
  /// cleared.
  Reaction react(const ContactState& state, double* history) const {
    ContactInParts contact(state);
    for_each_part([&](auto part, const auto& act) { act(load, this->*part, contact, history); });
    return sum(contact, history);
  }

  /// Calls run(part, act) for each part in order: `part` points to the member; act(load, part, contact,
  /// history) lets it act on a ContactInParts, with `load` of the law and `history` of the pair. Call sum()
  /// after the last part.
  template <class Run>
  static void for_each_part(const Run& run) {
    run(&ComposedLaw::attraction, [](const Load&, const auto& part, auto& contact, double* history) {
      contact.attraction = part.force(-contact.overlap, history + kAttractionHistory);
    });
    run(&ComposedLaw::normal, [](const Load&, const auto& part, auto& contact, double* history) {
      contact.static_normal = part.force(contact.overlap, contact.root_overlap, history);
    });
    run(&ComposedLaw::damping, [](const Load& load, const auto& part, auto& contact, double*) {
      contact.viscous = part.force(contact.overlap, contact.root_overlap, contact.separation_speed);
      contact.load = load.of(contact.static_normal.limit, contact.viscous);
    });
    run(&ComposedLaw::friction, [](const Load&, const auto& part, auto& contact, double* history) {
      contact.tangential = part.force(history + kFrictionHistory, contact.normal, contact.sliding,
                                      contact.root_overlap, contact.load, contact.time_step);
    });
    run(&ComposedLaw::rolling, [](const Load&, const auto& part, auto& contact, double* history) {
      contact.torque =
          part.torque(history + kRollingHistory, contact.normal, contact.spin, contact.root_overlap,
                      contact.static_normal, contact.load, contact.rolling_step);
    });
  }

  /// The reaction of all parts. Without contact, parts that need contact contribute nothing.
  static Reaction sum(const ContactInParts& contact, double* history) {
    const bool touches = contact.overlap > 0;
    const auto in_contact = [touches](double value) { return touches ? value : 0.0; };
    const Vector3 push =
        (contact.static_normal.force + contact.viscous) * contact.normal + contact.tangential;
    Reaction reaction;
    reaction.attraction = contact.attraction;
    reaction.force = contact.attraction * contact.normal +
                     Vector3{in_contact(push.x), in_contact(push.y), in_contact(push.z)};
    reaction.torque = {in_contact(contact.torque.x), in_contact(contact.torque.y),
                       in_contact(contact.torque.z)};
    reaction.load = in_contact(contact.load);
    reaction.viscous = in_contact(contact.viscous);
    reaction.attraction_power = contact.attraction * contact.separation_speed;
    reaction.normal_power = in_contact(contact.static_normal.force * contact.separation_speed);
    reaction.viscous_power = in_contact(contact.viscous * contact.separation_speed);
    reaction.friction_power = in_contact(dot(contact.tangential, contact.sliding));
    reaction.rolling_power = in_contact(dot(contact.torque, contact.spin));
    for (int k = 0; k < kAttractionHistory; ++k) history[k] = in_contact(history[k]);
    return reaction;
  }

  /// J stored in the normal part, recoverable.
  double contact_energy(double overlap, const double* history) const {
    return overlap > 0 ? normal.energy(overlap, history) : 0;
  }
  /// J of the distant attraction (negative), zero beyond its range.
  double attraction_energy(double overlap, const double* history) const {
    return attraction.energy(-overlap, history + kAttractionHistory);
  }
};

}  // namespace diefill::engine::laws
