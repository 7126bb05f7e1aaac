// Parts selected at run time: each Any... holds one of the parts in its list and is a part of that kind
// itself, so one instantiation of ComposedLaw serves every combination. For a single contact this is slower
// than a law composed of fixed parts, because every call selects; loops over many contacts select only once
// per part.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// Room for one of several plain structs.
template <class First, class... Others>
union OneOf {
  static_assert(std::is_trivially_copyable_v<First>);
  First first;
  OneOf<Others...> others;

  OneOf() {}  // nothing is held yet
  template <class Part>
  Part& as() {
    if constexpr (std::is_same_v<Part, First>)
      return first;
    else
      return others.template as<Part>();
  }
  template <class Part>
  const Part& as() const {
    return const_cast<OneOf*>(this)->template as<Part>();
  }
};
template <class Last>
union OneOf<Last> {
  static_assert(std::is_trivially_copyable_v<Last>);
  Last last;

  OneOf() {}
  template <class Part>
  Part& as() {
    return last;
  }
};

/// One of `Parts`, selected by which of their Parameters is given.
template <class... Parts>
class AnyPart {
 public:
  using Choice = std::variant<typename Parts::Parameters...>;
  struct Parameters {
    Choice choice;

    Parameters() = default;
    template <class Given>
    requires std::constructible_from<Choice, const Given&> Parameters(const Given& given)
        : choice(given) {}  // NOLINT: any part's parameters will do

    void check() const {
      std::visit([](const auto& given) { given.check(); }, choice);
    }
    Parameters similar(double scale) const {
      return std::visit([scale](const auto& given) { return Parameters(given.similar(scale)); }, choice);
    }
    /// query(given) of the selected parameters.
    template <class Query>
    auto query(const Query& query) const {
      return std::visit(query, choice);
    }
    // Facts that the parts of this kind state (parts.h); others do not compile.
    bool attracts() const {
      return query([](const auto& given) { return given.attracts(); });
    }
    bool includes_surface_forces() const {
      return query([](const auto& given) { return given.includes_surface_forces(); });
    }
    bool surface_forces() const {
      return query([](const auto& given) { return given.surface_forces(); });
    }
    bool damping_in_load() const {
      return query([](const auto& given) { return given.damping_in_load(); });
    }
    bool dissipates() const {
      return query([](const auto& given) { return given.dissipates(); });
    }
    double hertzian_modulus() const {
      return query([](const auto& given) { return given.hertzian_modulus(); });
    }
    double linear_stiffness() const {
      return query([](const auto& given) { return given.linear_stiffness(); });
    }
    void set_time_step(double time_step) {
      std::visit([time_step](auto& given) { given.set_time_step(time_step); }, choice);
    }
    double own_spin_arm() const {
      return query([](const auto& given) { return given.own_spin_arm(); });
    }
    bool set_work_of_adhesion(double work) {
      return std::visit([work](auto& given) { return given.set_work_of_adhesion(work); }, choice);
    }
    bool set_friction(double coefficient) {
      return std::visit([coefficient](auto& given) { return given.set_friction(coefficient); }, choice);
    }
    double largest_friction() const {
      return query([](const auto& given) { return given.largest_friction(); });
    }
    /// The parameters of one part, or null if another is selected.
    template <class SomePart>
    const typename SomePart::Parameters* of() const {
      return std::get_if<typename SomePart::Parameters>(&choice);
    }
  };

  AnyPart(const Parameters& given, const PairProperties& pair) : which_(given.choice.index()) {
    choose([&]<class Part>(std::type_identity<Part>) {
      std::construct_at(&held_.template as<Part>(), std::get<typename Part::Parameters>(given.choice), pair);
    });
  }

  /// Calls use(part) with the selected part.
  template <class Use>
  auto with(const Use& use) const {
    return choose([&]<class Part>(std::type_identity<Part>) { return use(as<Part>()); });
  }
  /// The selected part, which must be a Part: unchecked, because loops with a check do not vectorise. Callers
  /// know which part it is.
  template <class Part>
  const Part& as() const {
    return held_.template as<Part>();
  }
  /// Place of the selected part in the list.
  std::size_t which() const { return which_; }
  /// What number `k` of the history means: the same for the same part and unit; 0 where the part stores none.
  std::uint32_t history_meaning(int k) const {
    return with([&]<class Part>(const Part& part) -> std::uint32_t {
      if (k >= Part::kHistory) return 0;
      std::uint32_t unit = 0;
      if constexpr (requires { part.history_unit(); }) unit = part.history_unit();
      return 16 * unit + static_cast<std::uint32_t>(which_) + 1;
    });
  }

 protected:
  static constexpr int kMaxMemory = [] {
    int most = 0;
    ((most = std::max(most,
                      [] {
                        if constexpr (requires { Parts::kHistory; }) return Parts::kHistory;
                        return 0;
                      }())),
     ...);
    return most;
  }();
  /// kHistorySigns for any of the parts, which must agree where several use a number.
  static constexpr auto shared_signs() {
    HistorySigns<static_cast<std::size_t>(kMaxMemory)> signs = {};
    const auto take = [&](const auto& of_part) {
      for (std::size_t k = 0; k < of_part.size(); ++k) {
        if (signs[k] != 0 && signs[k] != of_part[k])
          throw std::logic_error("parts of one kind disagree on which entries of their history change sign");
        signs[k] = of_part[k];
      }
    };
    (take(Parts::kHistorySigns), ...);
    return signs;
  }

 private:
  /// Calls use(type_identity) of the selected part.
  template <class Use>
  auto choose(const Use& use) const {
    return choose_from<0, Parts...>(use);
  }
  template <std::size_t kFirst, class First, class... Others, class Use>
  auto choose_from(const Use& use) const {
    if constexpr (sizeof...(Others) > 0)
      if (which_ != kFirst) return choose_from<kFirst + 1, Others...>(use);
    return use(std::type_identity<First>{});
  }

  OneOf<Parts...> held_;
  std::size_t which_;
};

template <NormalPart... Parts>
struct AnyNormalOf : AnyPart<Parts...> {
  using AnyPart<Parts...>::AnyPart;
  static constexpr int kHistory = AnyPart<Parts...>::kMaxMemory;
  static constexpr auto kHistorySigns = AnyPart<Parts...>::shared_signs();
  bool hysteretic() const {
    return this->with([]<class Part>(const Part&) { return Part::hysteretic(); });
  }
  StaticForce force(double overlap, double root_overlap, double* history) const {
    return this->with([&](const auto& part) { return part.force(overlap, root_overlap, history); });
  }
  double energy(double overlap, const double* history) const {
    return this->with([&](const auto& part) { return part.energy(overlap, history); });
  }
  double stiffness(double overlap, const double* history) const {
    return this->with([&](const auto& part) { return part.stiffness(overlap, history); });
  }
};

template <DampingPart... Parts>
struct AnyDampingOf : AnyPart<Parts...> {
  using AnyPart<Parts...>::AnyPart;
  double force(double overlap, double root_overlap, double separation_speed) const {
    return this->with([&](const auto& part) { return part.force(overlap, root_overlap, separation_speed); });
  }
  double damping(double overlap, double root_overlap) const {
    return this->with([&](const auto& part) { return part.damping(overlap, root_overlap); });
  }
};

template <FrictionPart... Parts>
struct AnyFrictionOf : AnyPart<Parts...> {
  using AnyPart<Parts...>::AnyPart;
  static constexpr int kHistory = AnyPart<Parts...>::kMaxMemory;
  static constexpr auto kHistorySigns = AnyPart<Parts...>::shared_signs();
  Vector3 force(double* history, Vector3 normal, Vector3 sliding, double root_overlap, double load,
                double time_step) const {
    return this->with([&](const auto& part) {
      return part.force(history, normal, sliding, root_overlap, load, time_step);
    });
  }
};

template <RollingPart... Parts>
struct AnyRollingOf : AnyPart<Parts...> {
  using AnyPart<Parts...>::AnyPart;
  static constexpr int kHistory = AnyPart<Parts...>::kMaxMemory;
  static constexpr auto kHistorySigns = AnyPart<Parts...>::shared_signs();
  bool follows_time_step() const {
    return this->with([]<class Part>(const Part&) { return Part::follows_time_step(); });
  }
  Vector3 torque(double* history, Vector3 normal, Vector3 relative_spin, double root_overlap,
                 StaticForce static_force, double load, double time_step) const {
    return this->with([&](const auto& part) {
      return part.torque(history, normal, relative_spin, root_overlap, static_force, load, time_step);
    });
  }
};

template <AttractionPart... Parts>
struct AnyAttractionOf : AnyPart<Parts...> {
  using AnyPart<Parts...>::AnyPart;
  static constexpr int kHistory = AnyPart<Parts...>::kMaxMemory;
  static constexpr auto kHistorySigns = AnyPart<Parts...>::shared_signs();
  double range() const {
    return this->with([](const auto& part) { return part.range(); });
  }
  double force(double gap, double* history) const {
    return this->with([&](const auto& part) { return part.force(gap, history); });
  }
  double energy(double gap, const double* history) const {
    return this->with([&](const auto& part) { return part.energy(gap, history); });
  }
};

}  // namespace diefill::engine::laws
