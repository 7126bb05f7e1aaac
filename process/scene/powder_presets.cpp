#include "process/scene/powder_presets.h"

#include <array>
#include <stdexcept>

namespace diefill::process {
namespace {

struct Preset {
  const char* name;
  GrainModel model;
  double friction;          // mu
  double work_of_adhesion;  // J/m^2
  double rolling_friction;  // m
};

// Bierwisch 2009, Table 4.2; the last row from section 6.1 (Table C.6: w/R = 63.8 J/m^3).
constexpr std::array<Preset, 11> kPresets = {{
    {"ASC100.29 initial A", GrainModel::A, 0.25, 0, 0},
    {"ASC100.29 initial B", GrainModel::B, 0.25, 0, 3.75e-5},
    {"ASC100.29 initial C", GrainModel::C, 0.25, 0, 0},
    {"ASC100.29 initial D", GrainModel::D, 0.25, 0, 0},
    {"ASC100.29 A1", GrainModel::A, 1.0, 1.0e-2, 0},
    {"ASC100.29 A2", GrainModel::A, 0.3, 0, 0},
    {"ASC100.29 B1", GrainModel::B, 1.0, 1.0e-3, 3.75e-4},
    {"ASC100.29 C1", GrainModel::C, 1.0, 2.0e-1, 0},
    {"ASC100.29 D1", GrainModel::D, 1.0, 1.5e-1, 0},
    {"ASC100.29 D2", GrainModel::D, 1.0, 1.0e-2, 0},
    {"Distaloy AE", GrainModel::D, 1.0, 5.0e-3, 0},
}};

struct ReferenceSize {
  GrainModel model;
  double sphere_radius;   // m
  double grain_diameter;  // m, as printed
  double over_radius;     // d / R
};

// Bierwisch 2009, Table C.4.
constexpr std::array<ReferenceSize, 4> kReferenceSizes = {{
    {GrainModel::A, 1.5e-4, 3.0e-4, 2},
    {GrainModel::B, 1.5e-4, 3.0e-4, 2},
    {GrainModel::C, 8.9e-5, 3.56e-4, 4},
    {GrainModel::D, 7.84e-5, 4.7e-4, 6},
}};

const ReferenceSize& size_of(GrainModel model) {
  for (const ReferenceSize& size : kReferenceSizes) {
    if (size.model == model) return size;
  }
  throw std::logic_error("a grain model without a row in kReferenceSizes");
}

/// kg/m^3 of the real powder; 0 where it has not been published.
double apparent_density(const std::string& preset) {
  constexpr double kAsc10029 = 3000;  // Bierwisch 2009, section 4.1.1
  return preset.starts_with("ASC100.29") ? kAsc10029 : 0;
}

}  // namespace

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const Preset& preset : kPresets) names.emplace_back(preset.name);
  return names;
}

PowderSpec powder_preset(const std::string& name) {
  for (const Preset& preset : kPresets) {
    if (name != preset.name) continue;
    PowderSpec powder;  // the properties that all presets share are its defaults (Table C.4)
    powder.name = name;
    powder.model = preset.model;
    powder.sphere_radius = reference_sphere_radius(preset.model);
    powder.friction = preset.friction;
    powder.work_of_adhesion = preset.work_of_adhesion;
    powder.rolling_friction = preset.rolling_friction;
    powder.apparent_density = apparent_density(name);
    powder.grain_diameter = diameter_over_radius(preset.model) * powder.sphere_radius;
    return powder;
  }
  throw std::invalid_argument("no powder preset is called \"" + name + '"');
}

double nominal_grain_diameter(GrainModel model) {
  return size_of(model).grain_diameter;
}

double reference_sphere_radius(GrainModel model) {
  return size_of(model).sphere_radius;
}

double diameter_over_radius(GrainModel model) {
  return size_of(model).over_radius;
}

double coarse_graining_factor(const PowderSpec& powder) {
  return powder.grain_diameter / (diameter_over_radius(powder.model) * powder.sphere_radius);
}

}  // namespace diefill::process
