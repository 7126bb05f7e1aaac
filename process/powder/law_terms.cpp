#include "process/powder/law_terms.h"

#include <algorithm>

#include "engine/simulation/settings.h"
#include "process/powder/tool_surface.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/powder/grain_models.h"

namespace diefill::process {

namespace {

/// A part of the laws of [contact], once where grains and tools have the same.
void add_part(const PartDescription& grains, const PartDescription& walls, LawTerms& terms) {
  const auto add = [&](const PartDescription& part, const std::string& where) {
    const bool none = part.text == "none";
    (none ? terms.left_out : terms.used).push_back(part.kind + where + (none ? "" : " " + part.text));
  };
  if (grains.text == walls.text) return add(grains, "");
  add(grains, " among grains");
  add(walls, " with tools");
}

/// Whether `coefficient` is above zero for [walls] or for a tool that differs from it.
bool any_tool(const Scene& scene, double (*coefficient)(const Scene&, const ToolSpec&)) {
  return coefficient(scene, {}) > 0 ||
         std::any_of(scene.tools.begin(), scene.tools.end(),
                     [&](const ToolSpec& tool) { return coefficient(scene, tool) > 0; });
}

}  // namespace

LawTerms law_terms(const Scene& scene, const engine::SimulationSettings& settings) {
  const PowderSpec& powder = scene.powder;
  LawTerms terms;
  const auto& contact = scene.contact;
  if (contact)
    for (std::size_t k = 0; k < contact->grains.parts.size(); ++k)
      add_part(contact->grains.parts[k], contact->walls.parts[k], terms);
  const auto term = [&](const std::string& name, bool used) {
    (used ? terms.used : terms.left_out).push_back(name);
  };
  if (!contact) {
    term("Hertz repulsion", true);
    term("damping", powder.damping_over_radius > 0);
    term("Coulomb friction among grains", powder.friction > 0);
    term("Coulomb friction with tools", any_tool(scene, friction_of));
    term("cohesion among grains", powder.work_of_adhesion > 0);
    term("cohesion with tools", any_tool(scene, adhesion_of));
    term("rolling friction", has_rolling_friction(powder) && powder.rolling_friction > 0);
  }
  term("rotation of grains", settings.shape().rotates);
  term("air drag", settings.air_viscosity > 0);
  term("suction of air", scene.suction.has_value());
  return terms;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

}  // namespace diefill::process
