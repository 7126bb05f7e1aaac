// How much powder runs through an opening, by formula: answers that need no grain. Steady and starting flow
// through a slit or hole, and what a moving shoe leaves in a slit or cavity.
#pragma once

#include "engine/simulation/standard_gravity.h"

namespace diefill::process::continuum {

using engine::kStandardGravity;

/// The powder and the slit it runs through.
struct SlitFlow {
  double density = 0;  ///< kg/m^3, apparent density of the powder above the opening
  double width = 0;    ///< m, D, the narrow side of the opening, or its effective width (effective_width)
  double length = 0;   ///< m, b, across the flow
  double gravity = kStandardGravity;  ///< m/s^2
};

/// m, what coarse grains of size d leave of an opening: D - kEmptyAnnulus d, none below zero (Bierwisch 2009,
/// section 3.2.2).
double effective_width(double width, double grain_diameter);

/// kg/s through a round opening of `diameter` m: C rho_a sqrt(g) D^(5/2) (Bierwisch 2009, Eq. 5.1).
double beverloo_round(double coefficient, double density, double diameter, double gravity = kStandardGravity);

/// Numbers of flow that starts when a slit opens: a burst, then an approach to the steady rate (Bierwisch
/// 2009, Eqs. 5.12 to 5.15).
struct TransientCoefficients {
  double burst = 0;    ///< C_B, of the mass that falls before t_0
  double initial = 0;  ///< C_I, of the rate at t_0
  double steady = 0;   ///< C_F, of the rate in the end
  double beta = 0;     ///< how quickly the rate gets there, in units of sqrt(g/D)
};

/// ASC100.29 through a slit of 6 mm, measured (Bierwisch 2009, Tables 4.1, 5.3).
inline constexpr TransientCoefficients kMeasuredDischarge = {0.081, 0.024, 4.3, 0.093};
/// Hopper of model D grains, friction 0.5, no cohesion, simulated (Bierwisch 2009, Table 5.2).
inline constexpr TransientCoefficients kSimulatedDischarge = {0.05, 0.39, 0.92, 1.4};

/// Rate over rho_a b D sqrt(gD) at x = t sqrt(g/D) - 1/5 >= 0 (Bierwisch 2009, Eq. 5.15).
double rate_share(const TransientCoefficients& numbers, double x);
/// f_B(x): mass that has run out over rho_a b D^2 at x = t sqrt(g/D) - 1/5 >= 0 (Bierwisch 2009, Eq. 5.17).
double discharged_share(const TransientCoefficients& numbers, double x);

/// x_0, the burst's time over sqrt(D/g).
inline constexpr double kBurst = 0.2;

/// s, when the burst has passed: sqrt(D/g) / 5.
double burst_time(const SlitFlow& slit);
/// kg/s in the end: C_F rho_a b D sqrt(g D) (Bierwisch 2009, Eq. 5.13, beta outside the root).
double steady_rate(const TransientCoefficients& numbers, const SlitFlow& slit);
/// kg/s at `time` in s since the opening; without the burst, which is a mass (Bierwisch 2009, Eq. 5.15 with
/// the exponent -beta sqrt(g/D) (t - t_0)).
double rate(const TransientCoefficients& numbers, const SlitFlow& slit, double time);
/// kg that have run out until `time` in s: the integral of Eq. 5.15, half of the burst's time after which it
/// counts.
double discharged_mass(const TransientCoefficients& numbers, const SlitFlow& slit, double time);

/// What a shoe of `shoe_length` m leaves in a slit that it passes at `speed` m/s, kg (Bierwisch 2009,
/// Eqs. 4.1, 5.17). Valid below `largest_valid_speed`, where the powder would have no time to fall; throws
/// std::invalid_argument there.
double mass_of_passage(const TransientCoefficients& numbers, const SlitFlow& slit, double shoe_length,
                       double speed);
/// m/s, 5 sqrt(g D): beyond it Eq. 5.17 has no meaning.
double largest_valid_speed(const SlitFlow& slit);

/// Power law that is fitted to measured masses instead (Bierwisch 2009, Eq. 5.18).
struct PowerLawCoefficients {
  double coefficient = 0;  ///< C_S
  double exponent = 0;     ///< n
};
/// ASC100.29 (Bierwisch 2009, Table 5.3).
inline constexpr PowerLawCoefficients kMeasuredPowerLaw = {0.25, 0.20};
/// kg: C_S rho_a D b l (sqrt(g D) / v_s)^(1 + n).
double mass_of_passage(const PowerLawCoefficients& numbers, const SlitFlow& slit, double shoe_length,
                       double speed);

}  // namespace diefill::process::continuum
