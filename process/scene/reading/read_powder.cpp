#include <optional>

#include "process/scene/powder/grain_models.h"
#include "process/scene/powder/powder_file.h"
#include "process/scene/powder/powder_presets.h"
#include "process/scene/reading/plausibility.h"
#include "process/scene/reading/read_clump.h"
#include "process/scene/reading/sections.h"

namespace diefill::process {
namespace {

// Ranges span every published powder by several powers of ten and end where the unit is more likely wrong
// than the powder.
constexpr QuantityRule kSphereRadius = {Dimension::length, "0.0784 mm", "0 mm", "10 mm", true};
constexpr QuantityRule kGrainMass = {Dimension::mass, "0.0763 mg", "0 mg", "1 kg", true};
constexpr QuantityRule kGrainDiameter = {Dimension::length, "0.94 mm", "0 mm", "100 mm", true};
constexpr QuantityRule kReducedModulus = {Dimension::pressure, "10 MPa", "1e4 Pa", "1e12 Pa"};
constexpr QuantityRule kDamping = {Dimension::damping_over_radius, "1e6 Pa s/m", "0 Pa s/m", "1e9 Pa s/m"};
constexpr QuantityRule kTangential = {Dimension::pressure, "1 MPa", "0 Pa", "1e12 Pa"};
constexpr QuantityRule kAdhesion = {Dimension::work_of_adhesion, "0.005 J/m^2", "0 J/m^2", "10 J/m^2"};
constexpr QuantityRule kRolling = {Dimension::length, "0.0375 mm", "0 mm", "10 mm"};
constexpr QuantityRule kViscosity = {Dimension::viscosity, "2e-5 Pa s", "0 Pa s", "1 Pa s"};
constexpr QuantityRule kApparentDensity = {Dimension::density, "3.0 g/cm^3", "0.01 g/cm^3", "25 g/cm^3"};
constexpr NumberRule kFriction = {0, 10, false, "0.5"};

Choices<GrainModel> models() {
  Choices<GrainModel> choices;
  for (const GrainModelFacts& facts : grain_models()) choices.emplace_back(facts.name, facts.model);
  return choices;
}

Choices<std::string> presets() {
  Choices<std::string> choices;
  for (const std::string& name : preset_names()) choices.emplace_back(name, name);
  return choices;
}

/// The preset's model exchanged for another of the same solid volume: R follows, so that mass and density
/// stay.
void change_model(PowderSpec& powder, GrainModel model) {
  if (model == powder.model) return;
  powder.model = model;
  powder.sphere_radius = facts_of(model).sphere_radius;
  if (!has_rolling_friction(powder)) powder.rolling_friction = 0;
}

void read_rolling_friction(TableReader& table, PowderSpec& powder) {
  const auto given = table.quantity("rolling_friction", kRolling);
  if (!given) return;
  if (*given > 0 && !has_rolling_friction(powder)) {
    table.reject(
        "rolling_friction",
        "only model \"B\" (a rotating sphere) has rolling friction; remove the key or choose model B");
  }
  powder.rolling_friction = *given;
}

void read_overrides(TableReader& table, PowderSpec& powder) {
  if (!powder.clump) powder.grain_mass = table.quantity("grain_mass", kGrainMass).value_or(powder.grain_mass);
  powder.friction = table.number("friction", kFriction).value_or(powder.friction);
  powder.work_of_adhesion = table.quantity("work_of_adhesion", kAdhesion).value_or(powder.work_of_adhesion);
  powder.reduced_modulus =
      table.quantity("reduced_modulus", kReducedModulus).value_or(powder.reduced_modulus);
  powder.damping_over_radius =
      table.quantity("damping_over_radius", kDamping).value_or(powder.damping_over_radius);
  powder.tangential_over_radius =
      table.quantity("tangential_over_radius", kTangential).value_or(powder.tangential_over_radius);
  powder.air_viscosity = table.quantity("air_viscosity", kViscosity).value_or(powder.air_viscosity);
  powder.apparent_density =
      table.quantity("apparent_density", kApparentDensity).value_or(powder.apparent_density);
  read_rolling_friction(table, powder);
}

/// The grain size in exact terms: (d / R) times R. A user who writes the printed 0.47 mm of model D means the
/// tabulated R = 0.0784 mm, whose 6R is 0.4704 mm, and likewise its multiples.
void read_grain_diameter(TableReader& table, PowderSpec& powder, bool tabulated_radius) {
  const double exact = diameter_over_radius(powder) * powder.sphere_radius;
  const double nominal = tabulated_radius ? facts_of(powder.model).grain_diameter : exact;
  const auto wanted = table.quantity("grain_diameter", kGrainDiameter);
  powder.grain_diameter = wanted ? *wanted / nominal * exact : exact;
}

}  // namespace

PowderSpec read_powder(TableReader& table) {
  PowderSpec powder;
  const auto preset = table.choice("preset", presets());
  const bool own_clump = table.has("spheres") || table.has("spheres_file");
  if (preset) {
    powder = powder_preset(*preset);
    if (!own_clump) change_model(powder, table.choice("model", models()).value_or(powder.model));
    const bool weighed = table.has("grain_mass");
    if (weighed) powder.grain_mass = *table.quantity("grain_mass", kGrainMass);
    read_clump(table, powder, weighed ? 0 : grain_density(powder));
  } else {
    if (!table.has("model") && !own_clump)
      table.require("preset",
                    "\"Distaloy AE\", or give model, sphere_radius and grain_mass of your own powder");
    powder.name = "custom";
    if (own_clump) {
      powder.grain_mass = table.required_quantity("grain_mass", kGrainMass);
      read_clump(table, powder, 0);
    } else {
      powder.model = table.required_choice("model", models());
      powder.sphere_radius = table.required_quantity("sphere_radius", kSphereRadius);
      powder.grain_mass = table.required_quantity("grain_mass", kGrainMass);
    }
  }
  const auto radius = own_clump ? std::nullopt : table.quantity("sphere_radius", kSphereRadius);
  powder.sphere_radius = radius.value_or(powder.sphere_radius);
  powder.label = table.has("name") ? table.required_name("name", "iron") : powder.name;
  read_overrides(table, powder);
  read_grain_diameter(table, powder, !radius && !own_clump);
  read_sizes(table, powder);
  read_fitted_with(table);
  table.finish();
  check_density(table, powder);
  check_coarsening(table, powder);
  return powder;
}

CoarseGraining read_coarse_graining(TableReader& table) {
  static const Choices<CoarseGraining> choices = {{"bierwisch", CoarseGraining::bierwisch}};
  return table.choice("coarse_graining", choices).value_or(CoarseGraining::bierwisch);
}

}  // namespace diefill::process
