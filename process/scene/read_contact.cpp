// [contact]: which laws act between grains, and between grains and tools.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "engine/coarse_graining/methods.h"
#include "process/machine/powder_change.h"
#include "process/scene/contact_parts.h"
#include "process/scene/contact_spec.h"

namespace diefill::process {
namespace {

using namespace engine::laws;

/// A part as the scene chose it.
template <class Parameters>
struct ChosenPart {
  TableReader table;  ///< that names it; [contact] where it is left out
  const ContactPart<Parameters>* part;
  Parameters parameters;
  bool named;

  /// `line`: the reason of a refusal.
  [[noreturn]] void refuse(const std::string& line) const {
    throw SceneError(table.where(named ? "law" : "normal") + ": found \"" + part->name + "\", " + line);
  }
  PartDescription description(const std::string& kind) const { return {kind, part->description(parameters)}; }
};

/// Tables that may name the parts of a law, the most particular one first, [contact] last.
using ContactTables = std::vector<TableReader*>;

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

/// The five parts of one law.
struct ChosenLaw {
  ChosenPart<AnyNormal::Parameters> normal;
  ChosenPart<AnyDamping::Parameters> damping;
  ChosenPart<AnyFriction::Parameters> friction;
  ChosenPart<AnyRolling::Parameters> rolling;
  ChosenPart<AnyAttraction::Parameters> attraction;
  LoadRule load_rule;

  LawParameters law() const {
    return {normal.parameters,  damping.parameters,    friction.parameters,
            rolling.parameters, attraction.parameters, load_rule};
  }
  PairLawSpec pair() const {
    return {law(),
            {normal.description("normal"), damping.description("damping"), friction.description("friction"),
             rolling.description("rolling"), attraction.description("attraction")}};
  }
  /// Calls use(part) for each.
  template <class Use>
  void each(const Use& use) const {
    use(normal), use(damping), use(friction), use(rolling), use(attraction);
  }
};

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

Choices<std::string> scaling_rules() {
  Choices<std::string> rules;
  for (const auto& rule : engine::coarse_graining::kParameterRules) rules.emplace_back(rule.name, rule.name);
  for (const auto& method : engine::coarse_graining::kMethods) rules.emplace_back(method.name, method.name);
  return rules;
}

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
  if (powder.model == GrainModel::A && law.rolling.part->name != "none")
    law.rolling.refuse("but grains of model A do not rotate; remove it or choose another powder.model");
  if (law.rolling.parameters.own_spin_arm() > 0 && powder.model != GrainModel::B)
    law.rolling.refuse("a law of single rotating spheres; choose another law or powder.model = \"B\"");
  return law;
}

/// Keys of [powder] or [walls] that [contact] replaces, and that none of its parts reads.
void refuse_idle_keys(TableReader table, const std::vector<std::string>& keys, const ChosenLaw& law,
                      const TableReader& contact) {
  std::vector<std::string> read;
  law.each([&](const auto& part) {
    if (part.named) read.insert(read.end(), part.part->of_powder.begin(), part.part->of_powder.end());
  });
  for (const auto& key : keys)
    if (table.has(key) && std::find(read.begin(), read.end(), key) == read.end())
      table.reject(key, "[contact] in line " + std::to_string(contact.line()) +
                            " sets the laws, and none of them uses this key; remove it");
}

void refuse_idle_tables(TableReader& document, const ChosenLaw& grains, const ChosenLaw& walls,
                        const TableReader& contact) {
  refuse_idle_keys(*document.table("powder"),
                   {"friction", "work_of_adhesion", "rolling_friction", "reduced_modulus",
                    "damping_over_radius", "tangential_over_radius"},
                   grains, contact);
  if (const auto table = document.table("walls"))
    refuse_idle_keys(*table, {"friction", "work_of_adhesion"}, walls, contact);
  auto numerics = document.table("numerics");
  if (numerics && numerics->has("tangential_spring"))
    numerics->reject("tangential_spring", "[contact] in line " + std::to_string(contact.line()) +
                                              " sets the laws; set `cut_back` in its friction instead");
}

/// The powder with the friction and adhesion of a surface, for parts that leave theirs to the powder.
PowderSpec against(PowderSpec powder, double friction, double work_of_adhesion) {
  powder.friction = friction;
  powder.work_of_adhesion = work_of_adhesion;
  return powder;
}

/// Puts a tool's own friction and adhesion into its law.
void put_surface(TableReader& table, const ToolSpec& tool, ChosenLaw& law) {
  if (tool.friction && !law.friction.parameters.set_friction(*tool.friction))
    table.reject("friction", "friction law \"" + law.friction.part->name +
                                 "\" has no coefficient; name another law in [tool.contact.friction] or "
                                 "remove the key");
  if (tool.work_of_adhesion && !law.normal.parameters.set_work_of_adhesion(*tool.work_of_adhesion))
    table.reject("work_of_adhesion", "normal law \"" + law.normal.part->name +
                                         "\" has no adhesion; name another law in [tool.contact.normal] or "
                                         "remove the key");
}

}  // namespace

namespace {

/// The laws that [contact] makes with the parts that `own` names in place of its own; null: none.
ContactSpec read_laws(TableReader& contact, TableReader* own, const PowderSpec& powder,
                      const WallSpec& walls) {
  ContactTables among = {&contact};
  auto of_walls = contact.table("walls");
  ContactTables at_walls = {&contact};
  if (of_walls) at_walls.insert(at_walls.begin(), &*of_walls);
  std::optional<TableReader> own_walls;
  if (own != nullptr) {
    among.insert(among.begin(), own);
    at_walls.insert(at_walls.begin(), own);
    own_walls = own->table("walls");
    if (own_walls) at_walls.insert(at_walls.begin(), &*own_walls);
  }
  const ChosenLaw among_grains = read_law(among, powder);
  const ChosenLaw with_walls = read_law(at_walls, against(powder, walls.friction, walls.work_of_adhesion));
  if (own_walls) own_walls->finish();
  return {among_grains.pair(), with_walls.pair(), kBierwischScaling};
}

void refuse_without_coefficient(TableReader& step, const std::string& key, bool given, bool taken) {
  if (given && !taken)
    step.reject(key,
                "the law in use has no such coefficient; name another law in [step.contact] or remove "
                "the key");
}

/// Coefficients that a step gives and the laws in use have not.
void refuse_coefficients(TableReader& step, const PowderChange& change, ContactSpec contact) {
  auto &grains = contact.grains.law, &walls = contact.walls.law;
  refuse_without_coefficient(step, "friction", change.friction.has_value(),
                             grains.friction.set_friction(change.friction.value_or(0)));
  refuse_without_coefficient(step, "wall_friction", change.wall_friction.has_value(),
                             walls.friction.set_friction(change.wall_friction.value_or(0)));
  refuse_without_coefficient(step, "work_of_adhesion", change.work_of_adhesion.has_value(),
                             grains.normal.set_work_of_adhesion(change.work_of_adhesion.value_or(0)));
  refuse_without_coefficient(step, "wall_work_of_adhesion", change.wall_work_of_adhesion.has_value(),
                             walls.normal.set_work_of_adhesion(change.wall_work_of_adhesion.value_or(0)));
}

}  // namespace

std::shared_ptr<const Step> with_contact_of(TableReader& document, TableReader& step_table,
                                            std::shared_ptr<const Step> step, const Scene& scene) {
  const PowderChange* change = step->change();
  if (change == nullptr) return step;
  auto own = step_table.table("contact");
  auto contact = document.table("contact");
  if (own && !contact)
    step_table.reject("contact",
                      "it replaces parts of [contact], which this scene does not have; add "
                      "[contact], or set friction and work_of_adhesion of the step");
  if (!contact) return step;
  PowderChange changed = *change;
  ContactSpec spec = read_laws(*contact, own ? &*own : nullptr, scene.powder, scene.walls);
  spec.coarse_graining = scene.contact->coarse_graining;
  if (own) own->finish();
  refuse_coefficients(step_table, changed, spec);
  if (!own) return step;
  changed.contact = std::make_shared<const ContactSpec>(std::move(spec));
  const auto with_laws = std::make_shared<Change>(std::move(changed));
  with_laws->plan = step->plan;
  return with_laws;
}

std::shared_ptr<const PairLawSpec> read_tool_contact(TableReader& document, TableReader& table,
                                                     const ToolSpec& tool, const PowderSpec& powder,
                                                     const WallSpec& walls) {
  auto own = table.table("contact");
  auto contact = document.table("contact");
  if (own && !contact)
    table.reject("contact",
                 "it replaces parts of [contact], which this scene does not have; add [contact], or "
                 "set friction and work_of_adhesion of the tool");
  if (!contact || (!own && !tool.friction && !tool.work_of_adhesion)) return nullptr;
  auto of_walls = contact->table("walls");
  ContactTables tables = {&*contact};
  if (of_walls) tables.insert(tables.begin(), &*of_walls);
  if (own) tables.insert(tables.begin(), &*own);
  ChosenLaw law = read_law(tables, against(powder, tool.friction.value_or(walls.friction),
                                           tool.work_of_adhesion.value_or(walls.work_of_adhesion)));
  if (own) own->finish();
  put_surface(table, tool, law);
  return std::make_shared<const PairLawSpec>(law.pair());
}

std::optional<ContactSpec> read_contact(TableReader& document, const PowderSpec& powder,
                                        const WallSpec& walls) {
  auto contact = document.table("contact");
  if (!contact) return std::nullopt;
  contact->required_table("normal");
  const ChosenLaw among_grains = read_law({&*contact}, powder);
  auto table = contact->table("walls");
  ContactTables tables = {&*contact};
  if (table) tables.insert(tables.begin(), &*table);
  const ChosenLaw with_walls = read_law(tables, against(powder, walls.friction, walls.work_of_adhesion));
  if (table) table->finish();
  const auto rule = contact->choice("coarse_graining", scaling_rules());
  contact->finish();
  refuse_idle_tables(document, among_grains, with_walls, *contact);
  return ContactSpec{among_grains.pair(), with_walls.pair(), rule.value_or(kBierwischScaling)};
}

}  // namespace diefill::process
