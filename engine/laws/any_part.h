// Parts chosen while the program runs: each Any... holds one of the parts in its list and is a part of that
// kind itself, so that one instantiation of ComposedLaw serves every combination. Slower than a law composed
// of fixed parts by the choice at each call.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "engine/laws/parts.h"

namespace diefill::engine::laws {

/// One of `Parts`, chosen by which of their Parameters is given.
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
    /// The parameters of one part, or null if another is chosen.
    template <class SomePart>
    const typename SomePart::Parameters* of() const {
      return std::get_if<typename SomePart::Parameters>(&choice);
    }
  };

  AnyPart(const Parameters& given, const PairProperties& pair) : part_(make(given.choice, pair)) {}

 protected:
  /// Calls use(part) with the part that was chosen.
  template <class Use>
  auto with(const Use& use) const {
    return std::visit(use, part_);
  }
  static constexpr int kMostMemory = [] {
    int most = 0;
    ((most = std::max(most,
                      [] {
                        if constexpr (requires { Parts::kMemory; }) return Parts::kMemory;
                        return 0;
                      }())),
     ...);
    return most;
  }();

 private:
  using Held = std::variant<Parts...>;
  static Held make(const Choice& given, const PairProperties& pair) {
    using Maker = Held (*)(const Choice&, const PairProperties&);
    constexpr std::array<Maker, sizeof...(Parts)> kMakers = {
        [](const Choice& choice, const PairProperties& of) {
          return Held(std::in_place_type<Parts>, std::get<typename Parts::Parameters>(choice), of);
        }...};
    return kMakers[given.index()](given, pair);
  }

  Held part_;
};

template <NormalPart... Parts>
struct AnyNormalOf : AnyPart<Parts...> {
  using AnyPart<Parts...>::AnyPart;
  static constexpr int kMemory = AnyPart<Parts...>::kMostMemory;
  StaticForce force(double overlap, double root_overlap, double* memory) const {
    return this->with([&](const auto& part) { return part.force(overlap, root_overlap, memory); });
  }
  double energy(double overlap, const double* memory) const {
    return this->with([&](const auto& part) { return part.energy(overlap, memory); });
  }
  double stiffness(double overlap, const double* memory) const {
    return this->with([&](const auto& part) { return part.stiffness(overlap, memory); });
  }
};

template <DampingPart... Parts>
struct AnyDampingOf : AnyPart<Parts...> {
  using AnyPart<Parts...>::AnyPart;
  double force(double overlap, double root_overlap, double separation_speed) const {
    return this->with([&](const auto& part) { return part.force(overlap, root_overlap, separation_speed); });
  }
};

template <FrictionPart... Parts>
struct AnyFrictionOf : AnyPart<Parts...> {
  using AnyPart<Parts...>::AnyPart;
  static constexpr int kMemory = AnyPart<Parts...>::kMostMemory;
  Vector3 force(double* memory, Vector3 normal, Vector3 sliding, double root_overlap, double load,
                double time_step) const {
    return this->with(
        [&](const auto& part) { return part.force(memory, normal, sliding, root_overlap, load, time_step); });
  }
};

template <RollingPart... Parts>
struct AnyRollingOf : AnyPart<Parts...> {
  using AnyPart<Parts...>::AnyPart;
  static constexpr int kMemory = AnyPart<Parts...>::kMostMemory;
  Vector3 torque(double* memory, Vector3 normal, Vector3 relative_spin, double root_overlap,
                 StaticForce static_force, double load, double time_step) const {
    return this->with([&](const auto& part) {
      return part.torque(memory, normal, relative_spin, root_overlap, static_force, load, time_step);
    });
  }
};

template <AttractionPart... Parts>
struct AnyAttractionOf : AnyPart<Parts...> {
  using AnyPart<Parts...>::AnyPart;
  static constexpr int kMemory = AnyPart<Parts...>::kMostMemory;
  double range() const {
    return this->with([](const auto& part) { return part.range(); });
  }
  double force(double gap, double* memory) const {
    return this->with([&](const auto& part) { return part.force(gap, memory); });
  }
  double energy(double gap, const double* memory) const {
    return this->with([&](const auto& part) { return part.energy(gap, memory); });
  }
};

}  // namespace diefill::engine::laws
