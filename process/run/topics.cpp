#include "process/run/topics.h"

#include <cctype>

#include "engine/coarse_graining/methods.h"
#include "engine/numerics/vector_instructions.h"
#include "process/powder/law_terms.h"
#include "process/powder/scene_laws.h"
#include "process/powder/tool_surface.h"
#include "process/results/formatted.h"
#include "process/run/assemble.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/powder/grain_models.h"
#include "process/scene/setting.h"

#ifndef DIEFILL_LIBRARIES
#error "the build names the libraries in DIEFILL_LIBRARIES"
#endif

namespace diefill::process {

namespace {

void state(results::Topic& topic, const std::string& name, const std::string& text) {
  topic.name.push_back(name);
  topic.text.push_back(text);
}

std::string model_text(const PowderSpec& powder) {
  if (powder.clump) return "clump of " + std::to_string(powder.clump->spheres()) + " spheres";
  const GrainModelFacts& facts = facts_of(powder.model);
  return std::string(facts.name) + ": " + facts.words;
}

results::Topic powder_topic(const Scene& scene) {
  const PowderSpec& powder = scene.powder;
  const double fine = powder.grain_diameter / coarse_graining_factor(powder);
  results::Topic topic{"powder", {}, {}};
  state(topic, "Powder",
        powder.label.empty() || powder.label == powder.name ? powder.name
                                                            : powder.label + " (" + powder.name + ")");
  for (const auto& other : scene.other_powders)
    state(topic, "With " + other.powder.label,
          other.powder.name + ", " + amount_text(scene, other) + ", " + model_text(other.powder));
  if (powder.apparent_density > 0)
    state(topic, "Apparent density of the real powder",
          results::formatted("%.4g kg/m\u00b3", powder.apparent_density));
  state(topic, "Grain model", model_text(powder));
  state(topic, "Calibrated grain size", results::formatted("%.4g mm", 1e3 * fine));
  state(topic, "Grain size as simulated",
        results::formatted("%.4g mm", 1e3 * powder.grain_diameter) +
            (powder.sizes.empty() ? "" : " (of mean mass)"));
  if (!powder.sizes.empty()) state(topic, "Grain sizes", powder.sizes_text);
  const double factor = coarse_graining_factor(powder);
  state(topic, "Coarse graining",
        results::formatted("factor %.3g: ", factor) +
            results::formatted("one simulated grain represents %.4g calibrated grains of the same powder",
                               factor * factor * factor));
  return topic;
}

/// The laws of [contact], at the powder's own size.
void add_named_laws(const ContactSpec& contact, results::Topic& topic) {
  for (std::size_t k = 0; k < contact.grains.parts.size(); ++k) {
    const PartDescription &grains = contact.grains.parts[k], &walls = contact.walls.parts[k];
    std::string name = grains.kind == "normal" ? "Normal force" : grains.kind;
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    state(topic, name, grains.text + (walls.text == grains.text ? "" : "; with tools " + walls.text));
  }
}

/// Bierwisch's law of the powder.
void add_own_law(const Scene& scene, results::Topic& topic) {
  const auto contact = coarse_material(scene);
  state(topic, "Normal force",
        results::formatted("Hertz, reduced modulus %.3g MPa", 1e-6 * contact.reduced_modulus) +
            results::formatted(", damping %.3g Pa s (Bierwisch 2009, section 2.2)", contact.damping));
  state(topic, "Cohesion",
        contact.work_of_adhesion > 0
            ? results::formatted("work of adhesion %.3g J/m\u00b2 at the simulated size",
                                 contact.work_of_adhesion)
            : "none");
  state(topic, "Friction",
        results::formatted("Coulomb, coefficient %.3g, ", contact.friction) +
            results::formatted("tangential stiffness %.3g N/m", contact.tangential));
  if (has_rolling_friction(scene.powder))
    state(topic, "Rolling friction", results::formatted("%.3g mm", 1e3 * contact.rolling_friction));
}

results::Topic model_topic(const Scene& scene, const engine::SimulationSettings& settings) {
  results::Topic topic{"model", {}, {}};
  state(topic, "Method", "discrete element method: every simulated grain moves by Newton's laws");
  const auto& contact = scene.contact;
  if (contact)
    add_named_laws(*contact, topic);
  else
    add_own_law(scene, topic);
  state(topic, "Air",
        settings.air_viscosity > 0
            ? results::formatted("Stokes drag on every sphere, viscosity %.3g Pa s", settings.air_viscosity)
            : "none");
  if (scene.suction)
    state(topic, "Suction",
          "motion of the " + scene.suction->tool + " draws air through the powder in the cavity, " +
              results::formatted("particles of %.3g mm (Darcy, Kozeny-Carman), no leakage",
                                 1e3 * scene.suction->particle_diameter));
  state(topic, "Rule of coarse graining",
        !contact || contact->coarse_graining == kBierwischScaling
            ? "Bierwisch 2009, chapter 3: preserves free fall, bulk flow and packing"
        : engine::coarse_graining::parameter_rule(contact->coarse_graining) != nullptr
            ? contact->coarse_graining + ", which scales parameters of the laws"
            : contact->coarse_graining + ", which scales forces");
  return topic;
}

results::Topic walls_topic(const Scene& scene) {
  const WallSpec& walls = scene.walls;
  results::Topic topic{"walls", {}, {}};
  std::string meshes;
  for (const ToolSpec& tool : scene.tools)
    if (tool.walls.value_or(walls.kind) == WallKind::mesh) meshes += (meshes.empty() ? "" : ", ") + tool.name;
  state(topic, "Tools", "rigid, covered with wall spheres where powder can reach them");
  if (!meshes.empty())
    state(topic, "Mesh walls",
          "grains touch the triangles themselves, " +
              std::string(walls.contact_radius == MeshContactRadius::flat ? "as a flat wall"
                                                                          : "R_eff as on wall spheres") +
              ": " + meshes + "; their wall spheres serve only to cut Voronoi cells for measuring");
  state(topic, "Wall spheres",
        results::formatted("radius %.4g mm, ", 1e3 * walls.sphere_radius) +
            results::formatted("spacing %.3g radii", walls.spacing));
  if (scene.contact) return topic;
  state(topic, "Friction of walls", results::formatted("coefficient %.3g", walls.friction));
  state(topic, "Cohesion of walls",
        walls.work_of_adhesion > 0 ? results::formatted("%.3g J/m\u00b2", walls.work_of_adhesion) : "none");
  for (const ToolSpec& tool : scene.tools)
    if (has_own_surface(tool))
      state(topic, "Surface of " + tool.name,
            results::formatted("coefficient of friction %.3g, ", friction_of(scene, tool)) +
                results::formatted("work of adhesion %.3g J/m\u00b2", adhesion_of(scene, tool)));
  return topic;
}

results::Topic numerics_topic(const Scene& scene, const FillRun& run) {
  const auto& settings = run.simulation().settings();
  results::Topic topic{"numerics", {}, {}};
  state(topic, "Time step", results::formatted("%.4g s", settings.time_step));
  state(topic, "Critical time step", results::formatted("%.4g s", run.critical_time_step()));
  state(topic, "Threads", results::formatted("%d; results do not depend on the number", settings.threads));
  state(topic, "Gravity", results::formatted("%.4g m/s\u00b2", scene.gravity.norm()));
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (scene.numerics.period[axis])
      state(topic, std::string("Period along ") + "xyz"[axis],
            results::formatted("%.4g mm", 1e3 * *scene.numerics.period[axis]));
  return topic;
}

results::Topic assumptions_topic(const Scene& scene, const engine::SimulationSettings& settings) {
  results::Topic topic{"assumptions", {}, {}};
  state(topic, "Omitted terms (zero coefficient)", joined(law_terms(scene, settings).left_out));
  const bool monodisperse = scene.powder.sizes.empty() && scene.other_powders.empty();
  state(topic, "Grain size",
        !scene.other_powders.empty() ? "each powder has its own shape, density, sizes and laws"
        : !monodisperse              ? "grains have a few sizes, one shape, one material and one density"
                        : "all grains have one size and shape; the calibrated parameters stand in for size "
                          "distribution and lubricant");
  state(topic, "Stiffness",
        "grains are deliberately softer than metal to allow longer time steps; the effect on packing and "
        "flow is small");
  state(topic, "Density",
        "model grains are less dense than metal; compare solid fractions and fill ratios, not masses");
  state(topic, "Air", "no air flow: trapped air and suction filling are not modelled");
  state(topic, "Tools", "rigid, without wear; they follow the schedule whatever the force");
  state(topic, "Segregation",
        monodisperse ? "cannot occur with grains of one size"
                     : "is simulated, with the sizes of the model grains; see the mixing indices");
  if (coarse_graining_factor(scene.powder) > 1)
    state(topic, "Narrow places",
          "an opening acts narrower by 1.4 times the increase in grain size (Bierwisch 2009, section 3.2.2)");
  return topic;
}

/// What a setting chose; nothing for a scene that gives its own numbers.
void add_setting_topic(const Scene& scene, std::vector<results::Topic>& topics) {
  const auto chosen = chosen_numbers_in(scene.text);
  if (chosen.empty()) return;
  results::Topic topic{"setting", {}, {}};
  state(topic, "Chosen by", chosen.front());
  for (std::size_t k = 1; k < chosen.size(); ++k) {
    const std::size_t equals = chosen[k].find(" = ");
    state(topic, chosen[k].substr(0, equals), chosen[k].substr(equals + 3));
  }
  topics.push_back(std::move(topic));
}

/// For people.
const char* name_of(engine::InstructionSet set) {
  if (set == engine::InstructionSet::avx512) return "AVX-512";
  return set == engine::InstructionSet::avx2 ? "AVX2" : "baseline of the compiler";
}

/// Clang's own text names it.
#ifdef __clang__
constexpr const char* kCompiler = __VERSION__;
#else
constexpr const char* kCompiler = "GCC " __VERSION__;
#endif

}  // namespace

results::Topic versions_topic() {
  results::Topic topic{"versions", {}, {}};
  state(topic, "diefill", program_version());
  state(topic, "Compiler", kCompiler);
  state(topic, "Instruction set", name_of(engine::best_instruction_set()));
  state(topic, "Libraries", DIEFILL_LIBRARIES);
  return topic;
}

std::vector<results::Topic> topics(const Scene& scene, const FillRun& run) {
  std::vector<results::Topic> topics = {
      powder_topic(scene),        model_topic(scene, run.simulation().settings()),       walls_topic(scene),
      numerics_topic(scene, run), assumptions_topic(scene, run.simulation().settings()), versions_topic()};
  add_setting_topic(scene, topics);
  return topics;
}

}  // namespace diefill::process
