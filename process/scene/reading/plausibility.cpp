#include "process/scene/reading/plausibility.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/powder/grain_shape.h"
#include "process/input/numbers_apart.h"
#include "process/measure/fields/averaging_width.h"
#include "process/scene/powder/grain_models.h"

namespace diefill::process {
namespace {

constexpr double kLightestGrain = 100, kHeaviestGrain = 25000;  // kg/m^3, aerogel-like to osmium
constexpr double kFinest = 0.1, kCoarsest = 20;                 // wanted over reference grain size
constexpr double kPeriodOverDiameter = 4;

std::string millimetres(double length) {
  return number_text(length * 1e3) + " mm";
}

/// Two lengths that differ, with so many digits that they do so as text.
std::pair<std::string, std::string> millimetres_apart(double one, double other) {
  const auto words = numbers_apart(1e3 * one, 1e3 * other);
  return {words.first + " mm", words.second + " mm"};
}

/// Limits are met by what is written with the last digit that counts.
constexpr double kRounding = 1e-9;

double solid_volume(const PowderSpec& powder) {
  if (powder.clump) return powder.clump->solid_volume;
  return facts_of(powder.model).shape(powder.sphere_radius, powder.grain_mass).solid_volume;
}

void check_box(const TableReader& table, const PourSpec& pour, const PowderSpec& powder) {
  static const std::array<const char*, 3> axes = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const double from = pour.lower[axis], to = pour.upper[axis];
    const std::string along = axes[static_cast<std::size_t>(axis)];
    if (!(to > from)) {
      table.reject("to", "the box is empty along " + along + ": to (" + millimetres(to) +
                             ") must be greater than from (" + millimetres(from) + ")");
    }
    if (to - from < largest_grain(powder) * (1 - kRounding)) {
      const auto [box, grain] = millimetres_apart(to - from, largest_grain(powder));
      table.reject("to", "along " + along + " the box is " + box + " wide, less than one grain of " + grain +
                             "; widen it or reduce powder.grain_diameter");
    }
  }
}

void check_box_within_period(const TableReader& table, const PourSpec& pour, const NumericsSpec& numerics) {
  static const std::array<const char*, 3> axes = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!numerics.period[axis]) continue;
    const double half = *numerics.period[axis] / 2, slack = 1e-9 * half;
    const auto index = static_cast<Eigen::Index>(axis);
    for (const char* key : {"from", "to"}) {
      const double value = (std::string(key) == "from" ? pour.lower : pour.upper)[index];
      if (std::abs(value) <= half + slack) continue;
      const auto [reach, allowed] = millimetres_apart(std::abs(value), half);
      table.reject(key, std::string("along ") + axes[axis] + " the box reaches " + (value < 0 ? "-" : "") +
                            reach + ", but numerics.periodic allows only -" + allowed + " to " + allowed);
    }
  }
}

}  // namespace

double grain_density(const PowderSpec& powder) {
  return powder.grain_mass / solid_volume(powder);
}

void check_density(const TableReader& table, const PowderSpec& powder) {
  const double density = grain_density(powder);
  if (density >= kLightestGrain && density <= kHeaviestGrain) return;
  table.reject("grain_mass", "with sphere_radius " + millimetres(powder.sphere_radius) +
                                 " the grain density is " + number_text(density / 1000) +
                                 " g/cm^3, allowed: 0.1 to 25 g/cm^3; check both units");
}

void check_coarsening(const TableReader& table, const PowderSpec& powder) {
  const double factor = coarse_graining_factor(powder);
  if (factor >= kFinest * (1 - kRounding) && factor <= kCoarsest * (1 + kRounding)) return;
  const double own = powder.grain_diameter / factor;
  const double broken = (factor < kFinest ? kFinest : kCoarsest) * own;
  const auto [found, allowed] = millimetres_apart(powder.grain_diameter, broken);
  const std::string least = factor < kFinest ? allowed : millimetres(kFinest * own),
                    most = factor < kFinest ? millimetres(kCoarsest * own) : allowed;
  const std::string rule = "allowed: " + least + " to " + most +
                           ", 0.1 to 20 times the powder's calibrated size of " + millimetres(own) +
                           "; coarse graining is not valid outside this range";
  if (!powder.sizes.empty()) table.reject("sizes", "the grain of mean mass measures " + found + ", " + rule);
  table.reject("grain_diameter", "the grains measure " + found + ", " + rule);
}

void check_wall_is_tight(const TableReader& table, double sphere_radius, double spacing,
                         const PowderSpec& powder) {
  const auto hole_at = [&](double distance) { return (distance / std::numbers::sqrt2 - 1) * sphere_radius; };
  const double hole = hole_at(spacing);
  const double sphere = smallest_grain(powder) / diameter_over_radius(powder);
  const auto fits = [&](double distance) { return hole_at(distance) < sphere; };
  if (fits(spacing)) return;
  table.reject("spacing", "wall spheres of radius " + millimetres(sphere_radius) +
                              " at this spacing let powder spheres of radius " + millimetres(hole) +
                              " or less pass through, and the powder has spheres of " + millimetres(sphere) +
                              "; use a smaller spacing, such as " +
                              (spacing > 1.6 && fits(1.6) ? "1.6" : "1.4"));
}

void check_period(const TableReader& table, const std::string& key, double period, const PowderSpec& powder) {
  const double least = kPeriodOverDiameter * largest_grain(powder);
  if (period >= least * (1 - kRounding)) return;
  table.reject(key, "allowed: at least " + millimetres_apart(least, period).first +
                        ", four grain diameters, so that no grain touches its own periodic image");
}

void check_pour(const TableReader& table, const PourSpec& pour, const PowderSpec& powder,
                const NumericsSpec& numerics) {
  check_box(table, pour, powder);
  const double height = pour.upper.z() - pour.lower.z();
  if (pour.fill_height > height * (1 + kRounding)) {
    table.reject("fill_height", "the pour box is only " + millimetres_apart(height, pour.fill_height).first +
                                    " high; raise to[z] or reduce fill_height");
  }
  check_box_within_period(table, pour, numerics);
  const double least = 1 + 2 * pour.random_offset;
  constexpr double kClosestOfItself = 1.2;  // where the scene leaves the lattice to the program
  const double lattice = pour.lattice_constant > 0 ? pour.lattice_constant : kClosestOfItself;
  if (lattice < least * (1 - 1e-12)) {
    table.reject("lattice_constant",
                 "allowed: at least " + numbers_apart(least, lattice).first +
                     ", which is 1 + 2 random_offset, so that no grains overlap at the start");
  }
}

void check_averaging_width(const TableReader& table, double width, const PowderSpec& powder) {
  const double least = least_averaging_width(powder.grain_diameter);
  if (width >= least * (1 - kRounding)) return;
  table.reject("averaging_width", "allowed: at least " + millimetres_apart(least, width).first +
                                      ", a tenth of a grain: below, nearly every point lies between grains");
}

}  // namespace diefill::process
