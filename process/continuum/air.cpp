#include "process/continuum/air.h"

#include <algorithm>
#include <cmath>

#include "process/continuum/discharge.h"

namespace diefill::process::continuum {

double archimedes_number(double diameter, double density, double viscosity) {
  return kAirDensity * (density - kAirDensity) * kStandardGravity * std::pow(diameter, 3) /
         (viscosity * viscosity);
}

double air_number(double diameter, double density, double viscosity) {
  return archimedes_number(diameter, density, viscosity) * density / kAirDensity;
}

double carrying_flux(double permeability, double apparent_density, double viscosity, double gravity) {
  return permeability * apparent_density * gravity / viscosity;
}

double escape_time(double depth, double flux) {
  return depth / flux;
}

double suction_speed(double own_speed, double punch_speed, double flux) {
  if (!(own_speed > 0)) return 0;
  if (own_speed >= punch_speed) return punch_speed;
  const double square = own_speed * own_speed, half = 0.5 * square / flux;
  // The root of u^2 + 2 half u - square (1 + v / flux), written without the difference of nearly equal
  // numbers.
  const double constant = square + 2 * half * punch_speed;
  const double speed = constant / (half + std::sqrt(half * half + constant));
  return std::min(speed, punch_speed);
}

}  // namespace diefill::process::continuum
