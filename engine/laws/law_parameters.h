// Which parts a contact law has and their parameters,
// for one pair of materials: what a scene states.
#pragma once

#include <span>
#include <string>

#include "engine/laws/general_law.h"

namespace diefill::engine::laws {

/// The law between two materials. Each member takes the Parameters of any part of its kind, for example
/// `.normal = LudingNormal::Parameters{.loading = 150}`; by default: undamped, frictionless Hertz spheres.
struct LawParameters {
  AnyNormal::Parameters normal = {};
  AnyDamping::Parameters damping = {};
  AnyFriction::Parameters friction = {};
  AnyRolling::Parameters rolling = {};
  AnyAttraction::Parameters attraction = {};
  LoadRule load_rule = LoadRule::with_damping;

  /// Whether grains stick to what they touch.
  bool attracts() const { return normal.attracts() || attraction.attracts(); }
  /// The parameters that give l^2 times the forces at `scale` l times the lengths and the same speeds.
  LawParameters similar(double scale) const;
};

/// Throws std::invalid_argument with one line of reason when a parameter or a combination makes no sense:
/// - van der Waals attraction beside a normal force with the same surface forces, such as JKR's;
/// - damping from a restitution that belongs to another spring: Hertzian damping needs a Hertzian spring of
///   the same modulus, linear damping a linear first loading of the same k_1;
/// - rolling resistance of the elastic product k_1 h without a spring of that k_1.
/// Luding's friction goes with every spring: its limit comes from the normal part.
void require_sensible(const LawParameters& parameters);

/// The law of one pair. Does not check the combination, as it is called per pair: see require_sensible.
/// Throws std::invalid_argument where the rolling spring cannot be resolved in time (LudingRolling).
inline GeneralLaw make_law(const LawParameters& parameters, const PairProperties& pair) {
  return {AnyNormal(parameters.normal, pair),         AnyDamping(parameters.damping, pair),
          AnyFriction(parameters.friction, pair),     AnyRolling(parameters.rolling, pair),
          AnyAttraction(parameters.attraction, pair), Load(parameters.load_rule)};
}

/// The law between two materials by name, in either order.
struct MaterialPairLaw {
  std::string first, second;
  LawParameters law = {};
};

/// The law of materials `a` and `b`; throws std::invalid_argument naming both if there is none.
const LawParameters& law_between(std::span<const MaterialPairLaw> laws, const std::string& a,
                                 const std::string& b);

}  // namespace diefill::engine::laws
