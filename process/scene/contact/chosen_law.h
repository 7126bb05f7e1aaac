// The law of one pair of materials as a scene chose it: its five parts, each from the most specific table
// that names it.
#pragma once

#include <string>
#include <vector>

#include "process/scene/contact/contact_parts.h"
#include "process/scene/contact/contact_spec.h"

namespace diefill::process {

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

/// Tables that may name the parts of a law, the most specific one first, [contact] last.
using ContactTables = std::vector<TableReader*>;

/// The five parts of one law.
struct ChosenLaw {
  ChosenPart<engine::laws::AnyNormal::Parameters> normal;
  ChosenPart<engine::laws::AnyDamping::Parameters> damping;
  ChosenPart<engine::laws::AnyFriction::Parameters> friction;
  ChosenPart<engine::laws::AnyRolling::Parameters> rolling;
  ChosenPart<engine::laws::AnyAttraction::Parameters> attraction;
  engine::laws::LoadRule load_rule;

  engine::laws::LawParameters law() const {
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

/// The law that `tables` choose for `powder`. Throws SceneError for parts that do not go together or with the
/// grain model.
ChosenLaw read_law(const ContactTables& tables, const PowderSpec& powder);

}  // namespace diefill::process
