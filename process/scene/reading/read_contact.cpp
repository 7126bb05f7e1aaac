// [contact]: which laws act between grains, and between grains and tools.
#include <algorithm>
#include <deque>

#include "engine/coarse_graining/methods.h"
#include "process/machine/actions/powder_change.h"
#include "process/scene/contact/chosen_law.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/reading/sections.h"

namespace diefill::process {
namespace {

Choices<std::string> scaling_rules() {
  Choices<std::string> rules;
  for (const auto& rule : engine::coarse_graining::kParameterRules) rules.emplace_back(rule.name, rule.name);
  for (const auto& method : engine::coarse_graining::kMethods) rules.emplace_back(method.name, method.name);
  return rules;
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

/// The laws that [contact] makes with the parts that `own` tables, the most particular one first, name in
/// place of its own.
ContactSpec read_laws(TableReader& contact, ContactTables own, const PowderSpec& powder,
                      const WallSpec& walls) {
  std::deque<TableReader> of_walls;
  ContactTables at_walls;
  const auto take = [&](TableReader& table) {
    if (auto named = table.table("walls")) at_walls.push_back(&of_walls.emplace_back(*named));
    at_walls.push_back(&table);
  };
  for (TableReader* table : own) take(*table);
  // [contact.walls] is read as a whole by itself; beside more particular tables nothing of it may be left to
  // read.
  const std::size_t particular = of_walls.size();
  const bool alone = own.empty();
  take(contact);
  own.push_back(&contact);
  const ChosenLaw among_grains = read_law(own, powder);
  const ChosenLaw with_walls = read_law(at_walls, against(powder, walls.friction, walls.work_of_adhesion));
  for (std::size_t k = 0; k < (alone ? of_walls.size() : particular); ++k) of_walls[k].finish();
  return {among_grains.pair(), with_walls.pair(), kBierwischScaling};
}

/// `contact` of a powder or pair, which needs a [contact] that it replaces parts of.
std::optional<TableReader> own_contact(const std::optional<TableReader>& contact, TableReader& table) {
  auto own = table.table("contact");
  if (own && !contact)
    table.reject("contact", "it replaces parts of [contact], which this scene does not have; add [contact]");
  return own;
}

std::shared_ptr<const ContactSpec> contact_of_powder(std::optional<TableReader>& contact,
                                                     ContactTables tables, TableReader& table,
                                                     const OtherPowder& other, WallSpec walls) {
  auto own = own_contact(contact, table);
  if (!contact) return nullptr;
  if (own) tables.push_back(&*own);
  walls.friction = other.wall_friction.value_or(walls.friction);
  walls.work_of_adhesion = other.wall_work_of_adhesion.value_or(walls.work_of_adhesion);
  ContactSpec spec = read_laws(*contact, tables, other.powder, walls);
  if (own) own->finish();
  if (other.wall_friction && !spec.walls.law.friction.set_friction(*other.wall_friction))
    table.reject("wall_friction", "the friction law with walls has no coefficient; remove the key");
  if (other.wall_work_of_adhesion &&
      !spec.walls.law.normal.set_work_of_adhesion(*other.wall_work_of_adhesion))
    table.reject("wall_work_of_adhesion", "the normal law with walls has no adhesion; remove the key");
  return std::make_shared<const ContactSpec>(std::move(spec));
}

/// `table`: the [[powder_pair]]; null: there is none.
std::shared_ptr<const PairLawSpec> contact_of_pair(std::optional<TableReader>& contact, ContactTables tables,
                                                   TableReader* table, const PowderSpec& powder) {
  std::optional<TableReader> own;
  if (table != nullptr) own = own_contact(contact, *table);
  if (!contact) return nullptr;
  if (own) tables.push_back(&*own);
  tables.push_back(&*contact);
  PairLawSpec pair = read_law(tables, powder).pair();
  if (own) own->finish();
  if (table == nullptr) return std::make_shared<const PairLawSpec>(std::move(pair));
  if (table->has("friction") && !pair.law.friction.set_friction(powder.friction))
    table->reject("friction", "the friction law has no coefficient; name another law in contact.friction");
  if (table->has("work_of_adhesion") && !pair.law.normal.set_work_of_adhesion(powder.work_of_adhesion))
    table->reject("work_of_adhesion", "the normal law has no adhesion; name another law in contact.normal");
  return std::make_shared<const PairLawSpec>(std::move(pair));
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

OtherContacts read_other_contacts(TableReader& document, TableReader* step_contact, const Scene& scene) {
  OtherContacts found;
  auto contact = document.table("contact");
  const ContactTables of_step = step_contact ? ContactTables{step_contact} : ContactTables{};
  auto powders = document.tables("other_powder");
  for (std::size_t k = 0; k < powders.size(); ++k)
    found.powders.push_back(
        contact_of_powder(contact, of_step, powders[k], scene.other_powders[k], scene.walls));
  auto named = document.tables("powder_pair");
  for (std::size_t k = 0; k < scene.powder_pairs.size(); ++k) {
    const auto own = std::ranges::find_if(named, [&](auto& table) { return named_pair(table, scene) == k; });
    found.pairs.push_back(contact_of_pair(contact, of_step, own == named.end() ? nullptr : &*own,
                                          scene.powder_pairs[k].powder));
  }
  return found;
}

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
  const ContactTables of_step = own ? ContactTables{&*own} : ContactTables{};
  ContactSpec spec = read_laws(*contact, of_step, scene.powder, scene.walls);
  spec.coarse_graining = scene.contact->coarse_graining;
  if (own) own->finish();
  refuse_coefficients(step_table, changed, spec);
  if (!own) return step;
  changed.contact = std::make_shared<const ContactSpec>(std::move(spec));
  OtherContacts others = read_other_contacts(document, &*own, scene);
  changed.contact_of_others = std::move(others.powders);
  changed.contact_of_pairs = std::move(others.pairs);
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
