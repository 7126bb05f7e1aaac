#include "process/scene/contact/chosen_law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "process/scene/powder/grain_models.h"

namespace diefill::process {
namespace {

using namespace engine::laws;

/// Reads `kind` from the first table that names it; otherwise takes the first part.
template <class Parameters>
ChosenPart<Parameters> read_part(const std::string& kind, const ContactTables& tables,
                                 const ContactParts<Parameters>& parts, const PowderSpec& powder) {
  TableReader& contact = *tables.back();
  const auto holder =
      std::find_if(tables.begin(), tables.end() - 1, [&](TableReader* table) { return table->has(kind); });
  const auto table = (*holder)->table(kind);
  if (!table) return {contact, &parts.front(), {}, false};
  Choices<const ContactPart<Parameters>*> names;
  for (const auto& part : parts) names.emplace_back(part.name, &part);
  ChosenPart<Parameters> chosen{*table, nullptr, {}, true};
  chosen.part = chosen.table.required_choice("law", names);
  chosen.parameters = chosen.part->read(chosen.table, powder);
  chosen.table.finish();
  return chosen;
}

template <class Part, class Chosen>
auto* parameters_of(Chosen& chosen) {
  return std::get_if<typename Part::Parameters>(&chosen.parameters.choice);
}

/// Damping and rolling resistance that belong to a spring take its stiffness.
void link_to_spring(ChosenLaw& law) {
  if (auto* given = parameters_of<RestitutionDamping>(law.damping)) {
    given->modulus = law.normal.parameters.hertzian_modulus();
    if (given->modulus == 0)
      law.damping.refuse("which needs a Hertzian spring; with a linear spring use \"linear restitution\"");
  }
  if (auto* given = parameters_of<LinearRestitutionDamping>(law.damping)) {
    given->stiffness = law.normal.parameters.linear_stiffness();
    if (given->stiffness == 0)
      law.damping.refuse("which needs a linear spring; with a Hertzian spring use \"restitution\"");
  }
  if (auto* given = parameters_of<ElasticRolling>(law.rolling)) {
    given->stiffness = law.normal.parameters.linear_stiffness();
    if (given->stiffness == 0)
      law.rolling.refuse(
          "which needs k_1 of a linear spring; with a Hertzian spring use \"CDT\" or \"EPSD2\"");
  }
}

/// What a part shares with another: given once, it holds for both.
void link_to_friction(ChosenLaw& law) {
  if (auto* given = parameters_of<MindlinFriction>(law.friction); given && std::isnan(given->restitution)) {
    const auto* damping = parameters_of<RestitutionDamping>(law.damping);
    given->restitution = damping ? damping->restitution : 1;
  }
  if (auto* given = parameters_of<Epsd2Rolling>(law.rolling); given && std::isnan(given->shear_modulus)) {
    const auto* friction = parameters_of<MindlinFriction>(law.friction);
    if (friction == nullptr) law.rolling.table.require("shear_modulus", "\"2 MPa\"");
    given->shear_modulus = friction->shear_modulus;
  }
  if (auto* given = parameters_of<LudingRolling>(law.rolling)) {
    given->time_step = std::numeric_limits<double>::min();  // the run's, once it is known
    if (!std::isnan(given->tangential_stiffness)) return;
    const auto* friction = parameters_of<LudingFriction>(law.friction);
    if (friction == nullptr) law.rolling.table.require("tangential_stiffness", "\"60 N/m\"");
    given->tangential_stiffness = friction->stiffness;
  }
}

/// Whether the law is sensible once a part is left out.
bool sensible(const LawParameters& law) {
  try {
    require_sensible(law);
  } catch (const std::invalid_argument&) {
    return false;
  }
  return true;
}

/// Refuses parts on their own and together, at the part whose absence would make the law sensible.
void refuse_nonsense(const ChosenLaw& chosen) {
  chosen.each([](const auto& part) {
    try {
      part.parameters.check();
    } catch (const std::invalid_argument& reason) {
      part.refuse(reason.what());
    }
  });
  try {
    require_sensible(chosen.law());
  } catch (const std::invalid_argument& reason) {
    LawParameters without = chosen.law();
    without.attraction = {};
    if (sensible(without)) chosen.attraction.refuse(reason.what());
    without = chosen.law();
    without.rolling = {};
    if (sensible(without)) chosen.rolling.refuse(reason.what());
    chosen.damping.refuse(reason.what());
  }
}

const Choices<LoadRule>& load_rules() {
  static const Choices<LoadRule> rules = {{"with damping", LoadRule::with_damping},
                                          {"without damping", LoadRule::without},
                                          {"repulsive only", LoadRule::repulsive_only}};
  return rules;
}

}  // namespace

ChosenLaw read_law(const ContactTables& tables, const PowderSpec& powder) {
  ChosenLaw law{read_part("normal", tables, normal_parts(), powder),
                read_part("damping", tables, damping_parts(), powder),
                read_part("friction", tables, friction_parts(), powder),
                read_part("rolling", tables, rolling_parts(), powder),
                read_part("attraction", tables, attraction_parts(), powder),
                LoadRule::with_damping};
  if (!law.normal.parameters.damping_in_load()) law.load_rule = LoadRule::without;
  law.load_rule = tables.back()->choice("load_rule", load_rules()).value_or(law.load_rule);
  link_to_spring(law);
  link_to_friction(law);
  refuse_nonsense(law);
  if (!rotates(powder) && law.rolling.part->name != "none")
    law.rolling.refuse(std::string("but grains of model ") + name_of(powder.model) +
                       " do not rotate; remove it or choose another powder.model");
  if (law.rolling.parameters.own_spin_arm() > 0 && !has_rolling_friction(powder))
    law.rolling.refuse("a law of single rotating spheres; choose another law or powder.model = \"B\"");
  return law;
}

}  // namespace diefill::process
