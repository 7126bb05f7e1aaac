#include "engine/laws/law_parameters.h"

#include <cmath>

namespace diefill::engine::laws {
namespace {

/// Throws unless `found` equals `wanted` but for rounding; `found` is 0 where there is none.
void require_same(const std::string& who, const std::string& what, double wanted, double found) {
  std::ostringstream line;
  line << who << " is set for " << what << " " << wanted << ", but the normal spring has ";
  if (found > 0)
    line << found << "; give both the same value";
  else
    line << "none; choose another combination of normal force and " << who;
  require(std::abs(found - wanted) <= 1e-9 * wanted, line.str());
}

void require_one_surface_force(const LawParameters& parameters) {
  require(!parameters.attraction.surface_forces() || !parameters.normal.includes_surface_forces(),
          "van der Waals attraction repeats the adhesion of the normal force; use one of the two: set the "
          "attraction to none, or take a normal force without adhesion");
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
                 parameters.normal.hertzian_modulus());
  if (const auto* given = parameters.damping.of<LinearRestitutionDamping>())
    require_same("linear restitution damping", "stiffness k_1", given->stiffness,
                 parameters.normal.linear_stiffness());
  if (const auto* given = parameters.rolling.of<ElasticRolling>())
    require_same("rolling resistance by elastic product", "stiffness k_1", given->stiffness,
                 parameters.normal.linear_stiffness());
}

const LawParameters& law_between(std::span<const MaterialPairLaw> laws, const std::string& a,
                                 const std::string& b) {
  for (const auto& pair : laws)
    if ((pair.first == a && pair.second == b) || (pair.first == b && pair.second == a)) return pair.law;
  throw std::invalid_argument("no contact law between materials '" + a + "' and '" + b + "'; give one");
}

}  // namespace diefill::engine::laws
