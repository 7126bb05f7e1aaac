#include "process/run/law_terms.h"

namespace diefill::process {

LawTerms law_terms(const Scene& scene, const engine::SimulationSettings& settings) {
  const auto& grains = settings.grain_contact;
  const auto& walls = settings.wall_contact;
  LawTerms terms;
  const auto term = [&](const std::string& name, bool used) {
    (used ? terms.used : terms.left_out).push_back(name);
  };
  term("Hertz repulsion", true);
  term("damping", grains.damping > 0);
  term("Coulomb friction among grains", grains.friction > 0);
  term("Coulomb friction with tools", walls.friction > 0);
  term("cohesion among grains", grains.work_of_adhesion > 0);
  term("cohesion with tools", walls.work_of_adhesion > 0);
  term("rolling friction", scene.powder.model == GrainModel::B && grains.rolling_friction > 0);
  term("rotation of grains", settings.shape.rotates);
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
