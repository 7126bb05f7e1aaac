// The contact laws of the sources, one of each kind, for tests that must hold for all of them.
#pragma once

#include <string>
#include <vector>

#include "engine/laws/law_parameters.h"

namespace diefill::engine::laws {

/// A contact law of one of the sources.
struct NamedLaw {
  std::string name;
  LawParameters law;
};

/// Every normal force, damping, friction, rolling resistance and attraction at least once, for grains of
/// about half a millimetre.
inline std::vector<NamedLaw> laws_of_the_sources() {
  const double modulus = 5.5e6, shear = 1.13e6;
  LawParameters bierwisch{.normal = BierwischNormal::Parameters{.work_of_adhesion = 0.02}};
  bierwisch.damping = BierwischDamping::Parameters{.damping = 3};
  bierwisch.friction = CundallFriction::Parameters{.tangential = 100, .friction = 0.3};
  bierwisch.rolling = LoadRolling::Parameters{.rolling_friction = 0.1};

  LawParameters hu{.normal = HertzMindlinNormal::Parameters{.modulus = modulus}};
  hu.damping = RestitutionDamping::Parameters{.restitution = 0.3, .modulus = modulus};
  hu.friction = MindlinFriction::Parameters{.shear_modulus = shear, .friction = 0.3, .restitution = 0.3};
  hu.rolling = Epsd2Rolling::Parameters{.rolling_friction = 0.2, .shear_modulus = shear};
  LawParameters jkr = hu;
  jkr.normal = JkrNormal::Parameters{.modulus = modulus, .surface_energy = 0.05};
  jkr.load_rule = LoadRule::without;
  LawParameters wet = hu;
  wet.attraction = CapillaryBridge::Parameters{.surface_tension = 0.07};
  LawParameters kottlan{.normal = LudingNormal::Parameters{.loading = 150, .unloading = 600, .cohesion = 30}};
  kottlan.damping = LinearRestitutionDamping::Parameters{.restitution = 0.65, .stiffness = 150};
  kottlan.friction = LudingFriction::Parameters{
      .stiffness = 90, .damping = 1e-4, .static_friction = 0.7, .dynamic_friction = 0.5};
  kottlan.rolling = ElasticRolling::Parameters{.rolling_friction = 0.1, .stiffness = 150};
  kottlan.attraction = VanDerWaals::Parameters{.hamaker = 5e-18};
  LawParameters edinburgh = hu;
  edinburgh.normal =
      EdinburghNormal::Parameters{.modulus = modulus, .pull_off = 1e-7, .surface_energy = 0.02};
  LawParameters luding = kottlan;
  luding.rolling = LudingRolling::Parameters{
      .rolling_friction = 0.1, .tangential_stiffness = 90, .stiffness_ratio = 0.1, .time_step = 1e-7};
  return {{"Bierwisch", bierwisch}, {"Hertz", hu},        {"JKR", jkr},
          {"capillary", wet},       {"Kottlan", kottlan}, {"Luding rolling", luding},
          {"Edinburgh", edinburgh}};
}

/// A law under a method of coarse graining (coarse_graining/methods.h) at a scale.
struct ScaledCase {
  NamedLaw law;
  std::string method;
  double scale;
};

/// Every law of the sources unscaled and, at twice the size, under each of `methods`.
inline std::vector<ScaledCase> laws_under(const std::vector<std::string>& methods) {
  std::vector<ScaledCase> all;
  for (const auto& law : laws_of_the_sources()) {
    all.push_back({law, "none", 1});
    for (const auto& method : methods) all.push_back({law, method, 2});
  }
  return all;
}

}  // namespace diefill::engine::laws
