#include "process/results/figure_table.h"

#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace diefill::results {
namespace {

constexpr bool kCompared = true, kNotCompared = false;
constexpr int kDigits = 4;
constexpr ShownAs kNumber{"1", 1, kDigits}, kRatio{"1", 1, 3}, kPercent{"%", 100, 2},
    kGrams{"g", 1e3, kDigits}, kSeconds{"s", 1, kDigits}, kMillimetres{"mm", 1e3, 3},
    kFromMillimetres{"mm", 1, 3}, kModelDensity{"kg/m^3", 1, kDigits}, kRealDensity{"g/cm^3", 1e-3, kDigits};

// Name, unit, meaning; label, how it is shown; whether it is compared, short label, name for a further
// cavity.
constexpr std::array kFigures = {
    // What users decide by.
    Figure{"expected_mass_kg", "kg", "real powder in the cavity: fill ratio times the full die's mass",
           "mass of the real powder in the cavity", kGrams, kCompared, "mass of the real powder"},
    Figure{"estimated_mass_kg", "kg", "solid volume in the cavity times the metal's density",
           "mass of the real powder in the cavity, estimated", kGrams, kCompared,
           "mass of the real powder, estimated"},
    Figure{"fill_ratio", "1", "mass in the cavity over that of a die full at apparent density",
           "fill ratio of a die full at apparent density", ShownAs{"1", 1, 2}, kCompared, "fill ratio"},
    Figure{"filled_mass_kg", "kg", "mass of the grains whose centre lies in the cavity",
           "filled mass of model powder", kGrams, kCompared},
    Figure{"solid_fraction_mean", "1", "solid over cell volume of the grains two diameters below the surface",
           "mean solid fraction", kRatio, kCompared, nullptr, "solid_fraction"},
    Figure{"solid_fraction_field_std", "1", "standard deviation of the averaged field in the cavity",
           "standard deviation of the averaged solid fraction", kRatio, kCompared},
    Figure{"solid_fraction_std", "1", "standard deviation of single grains' solid fractions",
           "standard deviation over single grains", kRatio, kCompared},
    Figure{"solid_fraction_top_minus_bottom", "1", "upper less lower third of the powder's height",
           "solid fraction, top less bottom third", kRatio, kCompared},
    Figure{"solid_fraction_harmonic_1", "1", "amplitude of the first harmonic over the azimuth",
           "first harmonic over the azimuth, amplitude", kRatio, kCompared},
    Figure{"solid_fraction_harmonic_1_azimuth_deg", "deg", "where the first harmonic is largest",
           "first harmonic, densest at", ShownAs{"deg", 1, 3, 360}, kCompared},
    Figure{"solid_fraction_harmonic_2", "1", "amplitude of the second harmonic over the azimuth",
           "second harmonic over the azimuth, amplitude", kRatio, kCompared},
    Figure{"solid_fraction_harmonic_2_azimuth_deg", "deg", "where the second harmonic is largest",
           "second harmonic, densest at (and 180 deg on)", ShownAs{"deg", 1, 3, 180}, kCompared},
    Figure{"solid_fraction_along_travel_1", "1", "first term of the cosine series along the shoe's travel",
           "arrival end denser than far end, half the difference", kRatio, kCompared},
    Figure{"solid_fraction_along_travel_2", "1", "second term of the cosine series along the shoe's travel",
           "ends denser than the middle, half the difference", kRatio, kCompared},
    Figure{"mean_grain_diameter_filled_mm", "mm", "mean by mass of the grains in the cavity",
           "mean grain diameter in the cavity, by mass", kFromMillimetres, kCompared},
    Figure{"mean_grain_diameter_top_minus_bottom_mm", "mm", "mean by mass, upper less lower third",
           "mean grain diameter, top less bottom third", kFromMillimetres, kCompared},
    Figure{"mixing_index_height", "1", "1: sizes mixed over height as by chance; 0: separated",
           "mixing index over height", kRatio, kCompared},
    Figure{"mixing_index_azimuth", "1", "1: sizes mixed over azimuth as by chance; 0: separated",
           "mixing index over azimuth", kRatio, kCompared},
    Figure{"mixing_index_travel", "1", "1: sizes mixed along the travel as by chance; 0: separated",
           "mixing index along the travel", kRatio, kCompared},
    Figure{"first_powder_mass_share_filled", "1", "of [powder] where a scene has several, in the cavity",
           "mass share of the first powder in the cavity", kRatio, kCompared},
    Figure{"powder_mixing_index_height", "1", "1: powders mixed over height as by chance; 0: separated",
           "mixing index of powders over height", kRatio, kCompared},
    Figure{"powder_mixing_index_azimuth", "1", "1: powders mixed over azimuth as by chance; 0: separated",
           "mixing index of powders over azimuth", kRatio, kCompared},
    Figure{"powder_mixing_index_travel", "1", "1: powders mixed along the travel as by chance; 0: separated",
           "mixing index of powders along the travel", kRatio, kCompared},
    Figure{"fill_height_mm", "mm", "mean height of the powder surface above the cavity floor", "fill height",
           kFromMillimetres, kCompared},
    Figure{"cycle_time_s", "s", "time of the scene's steps, without waiting for rest", "cycle time",
           ShownAs{"s", 1, 3}, kCompared},
    Figure{"azimuthal_variation", "1", "range over mean of the filled fraction of 12 sectors",
           "azimuthal variation", kPercent},
    Figure{"axial_variation", "1", "range over mean of the solid fraction over height", "axial variation",
           kPercent},
    Figure{"full_die_mass_kg", "kg", "real powder in a die full at apparent density",
           "a die full at apparent density holds", kGrams, kNotCompared, "full die"},
    Figure{"apparent_density_kg_m3", "kg/m^3", "apparent density of the real powder",
           "apparent density of the real powder", kRealDensity, kNotCompared, "apparent density"},
    Figure{"solid_density_kg_m3", "kg/m^3", "of the metal, or of the model grains where that is not known",
           "density of the real powder's solid", kRealDensity},
    Figure{"apparent_density_is_estimate", "1",
           "0: as weighed; 1: the bed's solid fraction times the metal's density",
           "apparent density is an estimate", kNumber},
    Figure{"expected_fill_density_kg_m3", "kg/m^3", "fill ratio times the real powder's apparent density",
           "fill density of the real powder", ShownAs{"g/cm^3", 1e-3, 3}},
    Figure{"cavity_solid_fraction", "1", "all powder in it over its volume", "solid fraction of the cavity",
           kRatio},
    Figure{"solid_fraction_grains", "1", "grains in the mean solid fraction",
           "grains in the mean solid fraction", kNumber},
    Figure{"bulk_solid_fraction", "1", "solid fraction of all settled powder, in the cavity or not",
           "solid fraction of the powder", kRatio},
    Figure{"slope_of_*_deg", "deg", "slope of the heap's surface to the horizontal", "slope of *",
           ShownAs{"deg", 1, 3}},
    // Zones of [measure].
    Figure{"filled_mass_in_*_kg", "kg", "mass of the grains whose centre lies in the zone and in a cavity",
           "filled mass of model powder in *", kGrams},
    Figure{"mass_share_in_*", "1", "mass in the zone over that in all cavities", "share of the powder in *",
           kPercent},
    Figure{"solid_fraction_in_*", "1", "solid over cell volume of the zone's grains below the surface",
           "solid fraction in *", kRatio},
    // The model powder and its grains.
    Figure{"fill_density_kg_m3", "kg/m^3", "mass of model powder in the cavity over the cavity's volume",
           "fill density of model powder", kModelDensity},
    Figure{"model_apparent_density_kg_m3", "kg/m^3", "density of the model powder left outside the cavity",
           "apparent density of model powder (left outside the cavity)", kModelDensity},
    Figure{"grain_diameter_m", "m", "model grain size d; of several sizes, that of the grain of mean mass",
           "grain size d", kMillimetres},
    Figure{"smallest_grain_diameter_m", "m", "size of the smallest grains of the powder",
           "size of the smallest grains", kMillimetres},
    Figure{"largest_grain_diameter_m", "m", "size of the largest grains of the powder",
           "size of the largest grains", kMillimetres},
    Figure{"mean_grain_diameter_all_mm", "mm", "mean by mass of all grains",
           "mean grain diameter of all powder, by mass", kFromMillimetres},
    Figure{"first_powder_mass_share_all", "1", "of [powder] where a scene has several, in all powder",
           "mass share of the first powder in all powder", kRatio},
    Figure{"coarse_graining_factor", "1", "size of a model grain over that of the powder it represents",
           "coarse graining factor", kRatio},
    Figure{"grains", "1", "number of grains", "grains at the end", kNumber},
    Figure{"spheres", "1", "number of basic spheres of the powder", "spheres of powder at the end", kNumber},
    Figure{"grains_left", "1", "number of grains that left the tools or were cleared away",
           "grains that left the tools", kNumber},
    Figure{"grains_left_share", "1", "share of all grains that left the tools or were cleared away",
           "share of grains that left the tools", kPercent},
    Figure{"grains_sheared", "1", "number of grains wedged between tools that were taken out",
           "grains taken out between tools", kNumber},
    Figure{"mass_left_kg", "kg", "mass of the grains that left the tools or were cleared away",
           "mass of model powder that left the tools", kGrams},
    // Cavity, tools and motion.
    Figure{"cavity_volume_m3", "m^3", "volume of the cavity below the fill plane", "volume of the cavity",
           ShownAs{"cm^3", 1e6, kDigits}, kNotCompared, "volume", "volume_m3"},
    Figure{"cavity_narrowest_width_m", "m", "smallest horizontal width of the cavity; 0: unknown",
           "narrowest width of the cavity", ShownAs{"mm", 1e3, kDigits}, kNotCompared, "narrowest width"},
    Figure{"grain_diameter_over_cavity_width", "1", "size of the largest grains over the narrowest width",
           "grain size over narrowest width", kRatio},
    Figure{"wall_spheres", "1", "number of wall spheres of all tools", "wall spheres", kNumber},
    Figure{"shoe_speed_m_s", "m/s", "speed of the shoe while it moves, median", "shoe speed",
           ShownAs{"m/s", 1, 2}},
    // How near the run came to the limits of the method.
    Figure{"critical_time_step_s", "s", "time step beyond which the contacts are unstable",
           "critical time step", ShownAs{"µs", 1e6, kDigits}},
    Figure{"time_step_fraction", "1", "time step over the critical one", "time step over critical time step",
           kRatio},
    Figure{"deepest_overlap_ratio", "1", "deepest overlap of two grains' spheres over the spheres' radius",
           "deepest overlap of grains over the spheres' radius", kRatio},
    Figure{"overlap_limit_ratio", "1", "a run with a deeper overlap of grains stops",
           "limit of the overlap of grains over the spheres' radius", kRatio},
    Figure{"deepest_wall_overlap_ratio", "1", "deepest overlap of a sphere with a wall over its radius",
           "deepest overlap with walls over the spheres' radius", kRatio},
    Figure{"wall_overlap_limit_ratio", "1", "a run with a deeper overlap with walls stops",
           "limit of the overlap with walls over the spheres' radius", kRatio},
    Figure{"energy_balance_error", "1", "energy unaccounted for, relative to the energy exchanged",
           "energy unaccounted for over energy exchanged", ShownAs{"1", 1, 2}, kNotCompared,
           "energy balance error"},
    Figure{"energy_error_limit", "1", "limit of the energy balance error, either way",
           "limit of the energy unaccounted for over energy exchanged", ShownAs{"1", 1, 2}},
    // Size and speed of the computation.
    Figure{"finished", "1", "1: the scene was over; 0: an earlier instant of it, or a run that ended before",
           "scene was over", kNumber},
    Figure{"steps", "1", "time steps done", "steps", kNumber},
    Figure{"time_step_s", "s", "time step", "time step", ShownAs{"µs", 1e6, kDigits}},
    Figure{"simulated_s", "s", "simulated time", "simulated time", kSeconds},
    Figure{"wall_seconds", "s", "wall-clock time of the run", "computing time", kSeconds},
    Figure{"threads", "1", "threads that computed", "threads", kNumber},
    Figure{"ranks", "1", "ranks that computed, where the engine was not the built-in one", "ranks", kNumber},
    Figure{"sphere_steps", "1", "powder spheres times steps, those left out included", "sphere-steps",
           ShownAs{"million", 1e-6, 3}},
    Figure{"sphere_steps_left_out", "1", "sphere-steps saved where grains slept", "sphere-steps left out",
           ShownAs{"million", 1e-6, 3}},
    Figure{"sphere_steps_per_second", "1/s", "powder spheres times steps over wall-clock time",
           "speed of the computation", ShownAs{"million sphere-steps/s", 1e-6, 3}, kNotCompared, "speed"},
};

constexpr const char* kUnknown = "figure of the run, as in report.json";

struct UnitOfEnding {
  std::string_view ending;
  const char* unit;
};

// Longest endings first: "_per_second" is not "_second".
constexpr std::array kEndings = {
    UnitOfEnding{"_per_second", "1/s"},
    UnitOfEnding{"_seconds", "s"},
    UnitOfEnding{"_deg", "deg"},
    UnitOfEnding{"_kg_m3", "kg/m^3"},
    UnitOfEnding{"_m_s", "m/s"},
    UnitOfEnding{"_m3", "m^3"},
    UnitOfEnding{"_mm", "mm"},
    UnitOfEnding{"_kg", "kg"},
    UnitOfEnding{"_Pa", "Pa"},
    UnitOfEnding{"_s", "s"},
    UnitOfEnding{"_m", "m"},
    UnitOfEnding{"_J", "J"},
    UnitOfEnding{"_N", "N"},
};

/// "fill_ratio" of "cavity_2_fill_ratio"; other names as they are.
std::string without_cavity(const std::string& name) {
  constexpr std::string_view kCavity = "cavity_";
  if (!name.starts_with(kCavity)) return name;
  const std::size_t number = name.find_first_not_of("0123456789", kCavity.size());
  const bool numbered = number != std::string::npos && number > kCavity.size() && name[number] == '_';
  return numbered ? name.substr(number + 1) : name;
}

/// Equal, or matching where `pattern` has a `*`.
bool matches(std::string_view pattern, std::string_view name) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return pattern == name;
  return name.size() + 1 >= pattern.size() && name.starts_with(pattern.substr(0, star)) &&
         name.ends_with(pattern.substr(star + 1));
}

}  // namespace

std::span<const Figure> figure_table() {
  return kFigures;
}

const Figure* find_figure(const std::string& full_name) {
  const std::string name = without_cavity(full_name);
  for (const Figure& figure : kFigures)
    if (matches(figure.name, name) || (figure.other_name != nullptr && name == figure.other_name))
      return &figure;
  return nullptr;
}

const Figure& figure_called(const std::string& name) {
  const Figure* figure = find_figure(name);
  if (figure == nullptr) throw std::out_of_range("figure_table.cpp has no figure \"" + name + '"');
  return *figure;
}

StoredAs stored_as(const std::string& name, const std::string& shown_unit) {
  const Figure* figure = find_figure(name);
  if (figure == nullptr || figure->shown.unit != shown_unit) return {shown_unit, 1};
  return {figure->unit, figure->shown.factor};
}

std::string capitalised(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

std::string title_of(const Figure& figure) {
  return capitalised(figure.label);
}

std::string short_label(const Figure& figure) {
  return figure.short_label == nullptr ? figure.label : figure.short_label;
}

std::string label_of(const Figure& figure, const std::string& thing) {
  std::string label = figure.label;
  if (const std::size_t star = label.find('*'); star != std::string::npos) label.replace(star, 1, thing);
  return label;
}

double figure_of(const FillResult& result, const std::string& name) {
  if (name == "solid_fraction_mean") return result.summary.mean;
  if (name == "solid_fraction_std") return result.summary.std;
  const auto found = result.figures.find(name);
  return found == result.figures.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
}

std::pair<const char*, const char*> figure_meaning(const std::string& name) {
  if (const Figure* figure = find_figure(name)) return {figure->unit, figure->meaning};
  for (const auto& [ending, unit] : kEndings)
    if (name.ends_with(ending)) return {unit, kUnknown};
  return {"1", kUnknown};
}

bool counts(const std::string& name) {
  return name == "grains" || name == "spheres" || name == "wall_spheres" || name == "steps";
}

}  // namespace diefill::results
