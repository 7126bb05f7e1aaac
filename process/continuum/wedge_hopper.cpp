#include "process/continuum/wedge_hopper.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace diefill::process::continuum {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Mohr circle of steady flow, Pa.
struct Circle {
  double centre, radius;
};

/// Through the pre-shear point and tangent to the locus, with the tangent point on its left; tangent at
/// sigma_p itself where there is no such circle.
Circle steady_circle(const ShearTest& test) {
  const double phi = std::atan(test.slope), sine = std::sin(phi), cosine = std::cos(phi);
  const double sigma = test.preshear_normal, tau = test.preshear;
  // (sigma - s)^2 + tau^2 = (s sin phi + tau_0 cos phi)^2, a quadratic equation in s.
  const double a = cosine * cosine, half_b = sigma + test.cohesion * sine * cosine;
  const double c = sigma * sigma + tau * tau - test.cohesion * test.cohesion * cosine * cosine;
  const double root = half_b * half_b - a * c;
  if (root >= 0) {
    const double centre = (half_b - std::sqrt(root)) / a;
    return {centre, centre * sine + test.cohesion * cosine};
  }
  const double radius = (test.slope * sigma + test.cohesion) / cosine;
  return {sigma + radius * sine, radius};
}

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

}  // namespace

WedgeHopper wedge_hopper(const ShearTest& test, double gravity) {
  if (!(test.preshear_normal > 0 && test.preshear > 0 && test.slope > 0 && test.cohesion > 0 &&
        test.wall_angle > 0 && test.bulk_density > 0 && gravity > 0))
    throw std::invalid_argument("stresses, slope, wall angle and density of a shear test must be positive");
  WedgeHopper hopper;
  const Circle circle = steady_circle(test);
  const double effective = std::asin(circle.radius / circle.centre);
  hopper.effective_angle = effective / kDegree;
  hopper.half_angle =
      (std::exp(3.75 * std::pow(1.01, (hopper.effective_angle - 30) / 10)) - test.wall_angle) /
      (0.725 * std::pow(std::tan(effective), 0.2));
  const double alpha = hopper.half_angle * kDegree;
  hopper.flow_factor = flow_factor(effective, test.wall_angle * kDegree, alpha);
  hopper.strength = 2 * test.cohesion * (std::sqrt(1 + test.slope * test.slope) + test.slope);
  hopper.slot_width = (1 + hopper.half_angle / 200) * hopper.strength / (test.bulk_density * gravity);
  return hopper;
}

}  // namespace diefill::process::continuum
