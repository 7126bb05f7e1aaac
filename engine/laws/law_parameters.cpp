#include "engine/laws/law_parameters.h"

#include <optional>

namespace diefill::engine::laws {
namespace {

/// E* in Pa of the Hertzian spring in use, if it is one.
std::optional<double> hertzian_modulus(const AnyNormal::Parameters& normal) {
  if (const auto* given = normal.of<BierwischNormal>()) return 0.5 * given->reduced_modulus;
  if (const auto* given = normal.of<HertzMindlinNormal>()) return given->modulus;
  if (const auto* given = normal.of<JkrNormal>()) return given->modulus;
  return {};
}

/// k_1 in N/m of the linear or hysteretic spring in use, if it is one.
std::optional<double> linear_stiffness(const AnyNormal::Parameters& normal) {
  if (const auto* given = normal.of<LinearNormal>()) return given->stiffness;
  if (const auto* given = normal.of<LudingNormal>()) return given->loading;
  return {};
}

/// Throws unless `found` exists and equals `wanted` but for rounding.
void require_same(const std::string& who, const std::string& what, double wanted,
                  std::optional<double> found) {
  std::ostringstream line;
  line << who << " is set for " << what << " " << wanted << ", but the normal spring has ";
  if (found)
    line << *found << "; give both the same value";
  else
    line << "none; choose another combination of normal force and " << who;
  require(found && std::abs(*found - wanted) <= 1e-9 * wanted, line.str());
}

void require_one_surface_force(const LawParameters& parameters) {
  if (parameters.attraction.of<VanDerWaals>() == nullptr) return;
  const char* reason =
      "van der Waals attraction repeats the adhesion of the normal force; use one of the two: set the "
      "attraction to none, or take a normal force without adhesion";
  require(parameters.normal.of<JkrNormal>() == nullptr, reason);
  const auto* bierwisch = parameters.normal.of<BierwischNormal>();
  require(bierwisch == nullptr || bierwisch->work_of_adhesion == 0, reason);
}

}  // namespace

LawParameters LawParameters::similar(double scale) const {
  return {normal.similar(scale),  damping.similar(scale),    friction.similar(scale),
          rolling.similar(scale), attraction.similar(scale), load_rule};
}

void require_sensible(const LawParameters& parameters) {
  parameters.normal.check();
  parameters.damping.check();
  parameters.friction.check();
  parameters.rolling.check();
  parameters.attraction.check();
  require_one_surface_force(parameters);
  if (const auto* given = parameters.damping.of<RestitutionDamping>())
    require_same("Hertzian restitution damping", "modulus E*", given->modulus,
                 hertzian_modulus(parameters.normal));
  if (const auto* given = parameters.damping.of<LinearRestitutionDamping>())
    require_same("linear restitution damping", "stiffness k_1", given->stiffness,
                 linear_stiffness(parameters.normal));
  if (const auto* given = parameters.rolling.of<ElasticRolling>())
    require_same("rolling resistance by elastic product", "stiffness k_1", given->stiffness,
                 linear_stiffness(parameters.normal));
}

const LawParameters& law_between(std::span<const MaterialPairLaw> laws, const std::string& a,
                                 const std::string& b) {
  for (const auto& pair : laws)
    if ((pair.first == a && pair.second == b) || (pair.first == b && pair.second == a)) return pair.law;
  throw std::invalid_argument("no contact law between materials '" + a + "' and '" + b + "'; give one");
}

}  // namespace diefill::engine::laws
