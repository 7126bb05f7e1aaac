// Volume and mass of a sphere. The order of the factors is part of results to the last bit.
#pragma once

#include <numbers>

namespace diefill::engine {

/// m^3, of a sphere of that radius (m).
inline double sphere_volume(double radius) {
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

/// m^3, of a sphere of that diameter (m).
inline double sphere_volume_of_diameter(double diameter) {
  return std::numbers::pi / 6 * diameter * diameter * diameter;
}

/// kg, of a sphere of that density (kg/m^3) and radius (m).
inline double sphere_mass(double density, double radius) {
  return density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

}  // namespace diefill::engine
