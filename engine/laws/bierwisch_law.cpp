#include "engine/laws/bierwisch_law.h"

namespace diefill::engine::laws {

LawParameters bierwisch_law(const ContactParameters& parameters, SpringLimit spring_limit) {
  LawParameters law;
  law.normal = BierwischNormal::Parameters{parameters.reduced_modulus, parameters.work_of_adhesion};
  law.damping = BierwischDamping::Parameters{parameters.damping};
  law.friction = CundallFriction::Parameters{parameters.tangential, parameters.friction,
                                             spring_limit == SpringLimit::cut_back};
  if (parameters.rolling_friction != 0) law.rolling = OwnSpinRolling::Parameters{parameters.rolling_friction};
  return law;
}

std::optional<BierwischLaw> as_bierwisch(const LawParameters& law) {
  const auto* normal = law.normal.of<BierwischNormal>();
  const auto* damping = law.damping.of<BierwischDamping>();
  const auto* friction = law.friction.of<CundallFriction>();
  const auto* rolling = law.rolling.of<OwnSpinRolling>();
  const bool no_damping = law.damping.of<NoDamping>(), no_friction = law.friction.of<FreeSliding>(),
             no_rolling = law.rolling.of<FreeRolling>();
  if (!normal || !(damping || no_damping) || !(friction || no_friction) || !(rolling || no_rolling) ||
      !law.attraction.of<NoAttraction>() || law.load_rule != LoadRule::with_damping)
    return std::nullopt;
  BierwischLaw found;
  found.parameters = {.reduced_modulus = normal->reduced_modulus,
                      .damping = damping ? damping->damping : 0,
                      .tangential = friction ? friction->tangential : 0,
                      .friction = friction ? friction->friction : 0,
                      .work_of_adhesion = normal->work_of_adhesion,
                      .rolling_friction = rolling ? rolling->arm : 0};
  if (friction && !friction->cut_back) found.spring_limit = SpringLimit::free;
  return found;
}

}  // namespace diefill::engine::laws
