#include "process/results/figure_meaning.h"

#include <array>
#include <string_view>

namespace diefill::results {
namespace {

struct Meaning {
  std::string_view name;
  const char* unit;
  const char* description;
};

constexpr std::array kKnown = {
    Meaning{"finished", "1", "1: the scene was over; 0: an earlier instant of it"},
    Meaning{"filled_mass_kg", "kg", "mass of the grains whose centre lies in the cavity"},
    Meaning{"grains", "1", "number of grains"},
    Meaning{"spheres", "1", "number of basic spheres of the powder"},
    Meaning{"grains_left_share", "1", "share of all grains that left the tools or were cleared away"},
    Meaning{"wall_spheres", "1", "number of wall spheres of all tools"},
    Meaning{"steps", "1", "time steps done"},
    Meaning{"time_step_s", "s", "time step"},
    Meaning{"simulated_s", "s", "simulated time"},
    Meaning{"wall_seconds", "s", "wall-clock time of the run"},
    Meaning{"sphere_steps", "1", "powder spheres times steps, those left out included"},
    Meaning{"sphere_steps_left_out", "1", "sphere-steps saved where grains slept"},
    Meaning{"sphere_steps_per_second", "1/s", "powder spheres times steps over wall-clock time"},
    Meaning{"shoe_speed_m_s", "m/s", "speed of the shoe while it moves, median"},
    Meaning{"fill_density_kg_m3", "kg/m^3", "mass of model powder in the cavity over the cavity's volume"},
    Meaning{"model_apparent_density_kg_m3", "kg/m^3", "density of the model powder left outside the cavity"},
    Meaning{"apparent_density_kg_m3", "kg/m^3", "apparent density of the real powder"},
    Meaning{"apparent_density_is_estimate", "1",
            "0: as weighed; 1: the bed's solid fraction times the metal's density"},
    Meaning{"fill_ratio", "1", "mass in the cavity over that of a die full at apparent density"},
    Meaning{"full_die_mass_kg", "kg", "real powder in a die full at apparent density"},
    Meaning{"estimated_mass_kg", "kg", "solid volume in the cavity times the metal's density"},
    Meaning{"cavity_solid_fraction", "1", "solid fraction of the cavity: all powder in it over its volume"},
    Meaning{"bulk_solid_fraction", "1", "solid fraction of all settled powder, in the cavity or not"},
    Meaning{"expected_fill_density_kg_m3", "kg/m^3", "fill ratio times the real powder's apparent density"},
    Meaning{"expected_mass_kg", "kg", "real powder in the cavity: fill ratio times the full die's mass"},
    Meaning{"azimuthal_variation", "1", "range over mean of the filled fraction of 12 sectors"},
    Meaning{"axial_variation", "1", "range over mean of the solid fraction over height"},
    Meaning{"energy_balance_error", "1", "energy unaccounted for, relative to the energy turned over"},
    Meaning{"cycle_time_s", "s", "time of the scene's steps, without waiting for rest"},
    Meaning{"fill_height_mm", "mm", "mean height of the powder surface above the cavity floor"},
    Meaning{"solid_fraction_field_std", "1", "standard deviation of the averaged field in the cavity"},
    Meaning{"solid_fraction_top_minus_bottom", "1", "upper less lower third of the powder's height"},
    Meaning{"solid_fraction_harmonic_1", "1", "amplitude of the first harmonic over the azimuth"},
    Meaning{"solid_fraction_harmonic_1_azimuth_deg", "deg", "where the first harmonic is largest"},
    Meaning{"solid_fraction_harmonic_2", "1", "amplitude of the second harmonic over the azimuth"},
    Meaning{"solid_fraction_harmonic_2_azimuth_deg", "deg", "where the second harmonic is largest"},
    Meaning{"solid_fraction_along_travel_1", "1", "arrival end denser than far end, half the difference"},
    Meaning{"solid_fraction_along_travel_2", "1", "ends denser than the middle, half the difference"},
    Meaning{"smallest_grain_diameter_m", "m", "size of the smallest grains of the powder"},
    Meaning{"largest_grain_diameter_m", "m", "size of the largest grains of the powder"},
    Meaning{"mean_grain_diameter_filled_mm", "mm", "mean by mass of the grains in the cavity"},
    Meaning{"mean_grain_diameter_all_mm", "mm", "mean by mass of all grains"},
    Meaning{"mean_grain_diameter_top_minus_bottom_mm", "mm", "mean by mass, upper less lower third"},
    Meaning{"mixing_index_height", "1", "1: sizes mixed over height as by chance; 0: separated"},
    Meaning{"mixing_index_azimuth", "1", "1: sizes mixed over azimuth as by chance; 0: separated"},
    Meaning{"mixing_index_travel", "1", "1: sizes mixed along the travel as by chance; 0: separated"},
};

constexpr const char* kUnknown = "figure of the run, as in report.json";

// Longest endings first: "_per_second" is not "_second".
constexpr std::array kEndings = {
    Meaning{"_per_second", "1/s", kUnknown},
    Meaning{"_seconds", "s", kUnknown},
    Meaning{"_deg", "deg", kUnknown},
    Meaning{"_kg_m3", "kg/m^3", kUnknown},
    Meaning{"_m_s", "m/s", kUnknown},
    Meaning{"_m3", "m^3", kUnknown},
    Meaning{"_mm", "mm", kUnknown},
    Meaning{"_kg", "kg", kUnknown},
    Meaning{"_Pa", "Pa", kUnknown},
    Meaning{"_s", "s", kUnknown},
    Meaning{"_m", "m", kUnknown},
    Meaning{"_J", "J", kUnknown},
    Meaning{"_N", "N", kUnknown},
};

/// "fill_ratio" of "cavity_2_fill_ratio"; other names as they are.
std::string without_cavity(const std::string& name) {
  constexpr std::string_view kCavity = "cavity_";
  if (!name.starts_with(kCavity)) return name;
  const std::size_t number = name.find_first_not_of("0123456789", kCavity.size());
  const bool numbered = number != std::string::npos && number > kCavity.size() && name[number] == '_';
  return numbered ? name.substr(number + 1) : name;
}

}  // namespace

std::pair<const char*, const char*> figure_meaning(const std::string& full_name) {
  const std::string name = without_cavity(full_name);
  for (const Meaning& known : kKnown)
    if (known.name == name) return {known.unit, known.description};
  for (const Meaning& ending : kEndings)
    if (name.ends_with(ending.name)) return {ending.unit, ending.description};
  return {"1", kUnknown};
}

bool counts(const std::string& name) {
  return name == "grains" || name == "spheres" || name == "wall_spheres" || name == "steps";
}

}  // namespace diefill::results
