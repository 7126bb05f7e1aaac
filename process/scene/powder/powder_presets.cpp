#include "process/scene/powder/powder_presets.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "process/scene/powder/grain_models.h"

namespace diefill::process {
namespace {

struct Preset {
  const char* name;
  GrainModel model;
  double friction;          // mu
  double work_of_adhesion;  // J/m^2
  double rolling_friction;  // m
  const char* fitted_to;
  const char* use;
  const char* limits;
};

constexpr const char* kStartingPoint = "a starting point for your own calibration";
constexpr const char* kFlow = "flow through slits and openings";

// Bierwisch 2009, Table 4.2; Distaloy AE from section 6.1 (Table C.6: w/R = 63.8 J/m^3). Uses and limits:
// sections 4.1.4 to 4.1.7 (heaps, settled solid fraction, ring fillings) and README.md, "How far to trust
// it". In the order in which they are suggested: what fills dies first, what is for slits only last.
constexpr std::array<Preset, 11> kPresets = {{
    {"Distaloy AE", GrainModel::D, 1.0, 5.0e-3, 0, "filling of a narrow ring", "filling of dies by a shoe",
     "no apparent density published; set powder.apparent_density to your measured value"},
    {"ASC100.29 D2", GrainModel::D, 1.0, 1.0e-2, 0, "angle of repose", "filling of dies, heaps",
     "discharges more powder through a slit than measured; fills a ring close to measured levels, slightly "
     "high on the side where the shoe leaves at 0.5 m/s; settles at 0.32, real about 0.38"},
    {"ASC100.29 D1", GrainModel::D, 1.0, 1.5e-1, 0, "discharge through a slit",
     "flow through slits and openings, filling at 0.5 m/s",
     "very cohesive: heaps are far too steep (59 deg, measured 40) and a ring filled at 0.2 m/s deviates "
     "from measured levels; settles at 0.30, real about 0.38"},
    {"ASC100.29 C1", GrainModel::C, 1.0, 2.0e-1, 0, "discharge through a slit", kFlow,
     "heaps are irregular and creep: do not use for angles of repose"},
    {"ASC100.29 B1", GrainModel::B, 1.0, 1.0e-3, 3.75e-4, "discharge through a slit", kFlow,
     "heaps keep creeping: do not use for angles of repose; overstates the flow of shallow powder in the "
     "shoe"},
    {"ASC100.29 A2", GrainModel::A, 0.3, 0, 0, "angle of repose", "heaps, with few and fast spheres",
     "discharges the most powder through a slit and overfills a ring the most; settles at 0.57, real about "
     "0.38"},
    {"ASC100.29 initial D", GrainModel::D, 0.25, 0, 0, "nothing", kStartingPoint,
     "friction and cohesion are not calibrated; settles at 0.38 like the real powder"},
    {"ASC100.29 initial C", GrainModel::C, 0.25, 0, 0, "nothing", kStartingPoint,
     "friction and cohesion are not calibrated"},
    {"ASC100.29 initial B", GrainModel::B, 0.25, 0, 3.75e-5, "nothing", kStartingPoint,
     "friction and cohesion are not calibrated"},
    {"ASC100.29 initial A", GrainModel::A, 0.25, 0, 0, "nothing", kStartingPoint,
     "friction and cohesion are not calibrated; settles at 0.59, real about 0.38"},
    {"ASC100.29 A1", GrainModel::A, 1.0, 1.0e-2, 0, "discharge through a slit",
     "the published discharge through a slit only",
     "not for die filling: heaps are unrealistic, and rings are underfilled the most"},
}};

constexpr const char* kDischargeOnly = "ASC100.29 A1";

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

std::vector<PresetUse> preset_uses() {
  std::vector<PresetUse> uses;
  for (const Preset& preset : kPresets)
    uses.push_back({preset.name, preset.use, preset.limits, preset.fitted_to});
  return uses;
}

double preset_solid_density(const PowderSpec& powder) {
  constexpr double kIron = 7870;  // kg/m^3
  const auto names = preset_names();
  const bool known = std::find(names.begin(), names.end(), powder.name) != names.end();
  return known && powder.grain_mass == PowderSpec{}.grain_mass ? kIron : 0;
}

std::string preset_warning(const PowderSpec& powder) {
  if (powder.name != kDischargeOnly || powder.model != GrainModel::A) return {};
  return std::string("preset \"") + kDischargeOnly +
         "\" is not suitable for die filling: its heaps are unrealistic and it underfills rings; use "
         "\"ASC100.29 "
         "D2\" (diefill powders lists the use of each preset)";
}

PowderSpec powder_preset(const std::string& name) {
  for (const Preset& preset : kPresets) {
    if (name != preset.name) continue;
    PowderSpec powder;  // the properties that all presets share are its defaults (Table C.4)
    powder.name = name;
    powder.model = preset.model;
    powder.sphere_radius = facts_of(preset.model).sphere_radius;
    powder.friction = preset.friction;
    powder.work_of_adhesion = preset.work_of_adhesion;
    powder.rolling_friction = preset.rolling_friction;
    powder.apparent_density = apparent_density(name);
    powder.grain_diameter = diameter_over_radius(powder) * powder.sphere_radius;
    return powder;
  }
  throw std::invalid_argument("unknown powder preset \"" + name + '"');
}

double diameter_over_radius(const PowderSpec& powder) {
  if (powder.clump) return 2 * powder.clump->bounding_radius() / powder.clump->sphere_radius;
  return facts_of(powder.model).over_radius;
}

double coarse_graining_factor(const PowderSpec& powder) {
  return powder.grain_diameter / (diameter_over_radius(powder) * powder.sphere_radius);
}

}  // namespace diefill::process
