#include "process/continuum/discharge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "process/powder/empty_annulus.h"

namespace diefill::process::continuum {

namespace {

/// m/s
double velocity_scale(const SlitFlow& slit) {
  return std::sqrt(slit.gravity * slit.width);
}

}  // namespace

double rate_share(const TransientCoefficients& numbers, double x) {
  return numbers.steady * (1 - (1 - numbers.initial / numbers.steady) * std::exp(-numbers.beta * x));
}

double discharged_share(const TransientCoefficients& numbers, double x) {
  const double approach =
      (1 - numbers.initial / numbers.steady) / numbers.beta * std::expm1(-numbers.beta * x);
  return numbers.burst + numbers.steady * (x + approach);
}

double effective_width(double width, double grain_diameter) {
  return std::max(0.0, width - kEmptyAnnulus * grain_diameter);
}

double beverloo_round(double coefficient, double density, double diameter, double gravity) {
  return coefficient * density * std::sqrt(gravity) * std::pow(diameter, 2.5);
}

double burst_time(const SlitFlow& slit) {
  return kBurst * std::sqrt(slit.width / slit.gravity);
}

double steady_rate(const TransientCoefficients& numbers, const SlitFlow& slit) {
  return numbers.steady * slit.density * slit.length * slit.width * velocity_scale(slit);
}

double rate(const TransientCoefficients& numbers, const SlitFlow& slit, double time) {
  const double since = (time - burst_time(slit)) * std::sqrt(slit.gravity / slit.width);
  if (since < 0) return 0;
  return slit.density * slit.length * slit.width * velocity_scale(slit) * rate_share(numbers, since);
}

double discharged_mass(const TransientCoefficients& numbers, const SlitFlow& slit, double time) {
  const double whole = slit.density * slit.length * slit.width * slit.width;
  const double since = (time - burst_time(slit)) * std::sqrt(slit.gravity / slit.width);
  if (since < 0) return time > burst_time(slit) / 2 ? numbers.burst * whole : 0;
  return whole * discharged_share(numbers, since);
}

double largest_valid_speed(const SlitFlow& slit) {
  return velocity_scale(slit) / kBurst;
}

double mass_of_passage(const TransientCoefficients& numbers, const SlitFlow& slit, double shoe_length,
                       double speed) {
  const double ratio = velocity_scale(slit) / speed;
  if (!(speed > 0) || ratio < kBurst) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "a shoe speed of %.4g m/s is outside the formula's range: above 0, up to %.4g m/s", speed,
                  largest_valid_speed(slit));
    throw std::invalid_argument(text);
  }
  return slit.density * slit.width * slit.length * shoe_length * discharged_share(numbers, ratio - kBurst);
}

double mass_of_passage(const PowerLawCoefficients& numbers, const SlitFlow& slit, double shoe_length,
                       double speed) {
  return numbers.coefficient * slit.density * slit.width * slit.length * shoe_length *
         std::pow(velocity_scale(slit) / speed, 1 + numbers.exponent);
}

}  // namespace diefill::process::continuum
