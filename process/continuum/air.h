// Air in the way of powder: whether it slows a filling, how long it takes to leave a closed cavity, and what
// a falling punch draws along. SI units.
#pragma once

namespace diefill::process::continuum {

/// Air at 20 degrees C and 1 bar.
inline constexpr double kAirDensity = 1.2;       ///< kg/m^3
inline constexpr double kAirViscosity = 1.8e-5;  ///< Pa s

/// Ar = rho_air (rho_s - rho_air) g d^3 / mu^2 of particles of `diameter` m and `density` kg/m^3 in air.
double archimedes_number(double diameter, double density, double viscosity = kAirViscosity);

/// Ar times rho_s / rho_air: orders powders by how much air slows their flow into a die (Guo, Kafui, Wu,
/// Thornton and Seville 2009, AIChE Journal 55, 49).
double air_number(double diameter, double density, double viscosity = kAirViscosity);

/// m/s, flux of air through powder at rest whose drag carries the powder's weight: k rho_a g / mu, with the
/// permeability k in m^2 (Darcy 1856).
double carrying_flux(double permeability, double apparent_density, double viscosity, double gravity);

/// s until the air of a cavity of `depth` m has left upwards through powder that covers its opening and whose
/// weight drives it out: depth over carrying_flux().
double escape_time(double depth, double flux);

/// m/s that powder sinks at behind a punch that falls at `punch_speed`: by itself it runs at `own_speed`; air
/// that the punch draws past it adds to gravity by the flux past it over `flux` (carrying_flux()). At most
/// `punch_speed`; 0 where powder does not run by itself, as through an opening that its grains do not pass.
/// Root of u^2 = own_speed^2 (1 + (punch_speed - u) / flux), ours: a Beverloo flow is
/// proportional to the root of gravity.
double suction_speed(double own_speed, double punch_speed, double flux);

}  // namespace diefill::process::continuum
