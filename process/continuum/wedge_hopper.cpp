#include "process/continuum/wedge_hopper.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "process/continuum/yield_locus.h"
#include "process/input/units.h"

namespace diefill::process::continuum {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

double flow_factor(double effective, double wall, double half_angle) {
  const double sine = std::sin(effective);
  const double beta = 0.5 * (wall + std::asin(std::sin(wall) / sine));
  const double x = sine / (1 - sine) * (std::sin(2 * beta + half_angle) / std::sin(half_angle) + 1);
  const double both = std::sin(beta + half_angle);
  const double y =
      ((beta + half_angle) * std::sin(half_angle) + std::sin(beta) * both) / ((1 - sine) * both * both);
  const double shape = 1 + half_angle / kDegree / 200;
  return y * (1 + sine) * shape / (2 * (x - 1) * std::sin(half_angle));
}

std::string degrees(double angle) {
  return number_text(0.1 * std::round(10 * angle)) + " deg";
}

void refuse_not_positive(const ShearTest& test, double gravity) {
  if (!(test.preshear_normal > 0 && test.preshear > 0 && test.slope > 0 && test.cohesion > 0 &&
        test.wall_angle > 0 && test.bulk_density > 0 && gravity > 0))
    throw std::invalid_argument("stresses, slope, wall angle and density of a shear test must be positive");
}

/// Jenike's charts hold for walls along which powder slides more easily than along itself.
void refuse_rough_wall(const ShearTest& test, double effective_angle) {
  if (!std::isfinite(effective_angle))
    throw std::invalid_argument(
        "the shear test gives no effective angle of internal friction, as its circle of steady flow reaches "
        "into tension; check cohesion and pre-shear");
  if (!(test.wall_angle < effective_angle))
    throw std::invalid_argument("found a wall angle of " + degrees(test.wall_angle) +
                                ", allowed: less than " + degrees(effective_angle) +
                                ", the effective angle of internal friction, because powder does not slide "
                                "along a rougher wall; choose a smoother wall, or check the shear test");
}

}  // namespace

WedgeHopper wedge_hopper(const ShearTest& test, double gravity) {
  refuse_not_positive(test, gravity);
  WedgeHopper hopper;
  const YieldLocus locus{test.slope, test.cohesion};
  hopper.effective_angle = effective_angle(steady_circle(locus, {test.preshear_normal, test.preshear}));
  refuse_rough_wall(test, hopper.effective_angle);
  const double effective = hopper.effective_angle * kDegree;
  hopper.half_angle =
      (std::exp(3.75 * std::pow(1.01, (hopper.effective_angle - 30) / 10)) - test.wall_angle) /
      (0.725 * std::pow(std::tan(effective), 0.2));
  if (!(hopper.half_angle > 0))
    throw std::invalid_argument("found a wall angle of " + degrees(test.wall_angle) +
                                ", at which no wedge hopper has mass flow: its half angle would be " +
                                degrees(hopper.half_angle) + ", allowed: above 0; choose a smoother wall");
  const double alpha = hopper.half_angle * kDegree;
  hopper.flow_factor = flow_factor(effective, test.wall_angle * kDegree, alpha);
  hopper.strength = unconfined_circle(locus).major();
  hopper.slot_width = (1 + hopper.half_angle / 200) * hopper.strength / (test.bulk_density * gravity);
  return hopper;
}

}  // namespace diefill::process::continuum
