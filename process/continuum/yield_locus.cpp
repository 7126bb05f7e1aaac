#include "process/continuum/yield_locus.h"

#include <cmath>
#include <numbers>

#include "process/results/none.h"

namespace diefill::process::continuum {
YieldLocus yield_locus_through(const std::vector<StressPoint>& points) {
  const auto count = static_cast<double>(points.size());
  double normal = 0, shear = 0, squares = 0, products = 0;
  for (const StressPoint& point : points) normal += point.normal / count, shear += point.shear / count;
  for (const StressPoint& point : points) {
    squares += (point.normal - normal) * (point.normal - normal);
    products += (point.normal - normal) * (point.shear - shear);
  }
  if (!(squares > 0)) return {kNone, kNone};
  const double slope = products / squares;
  return {slope, shear - slope * normal};
}

MohrCircle unconfined_circle(const YieldLocus& locus) {
  const double strength = 2 * locus.cohesion * (std::sqrt(1 + locus.slope * locus.slope) + locus.slope);
  return {0.5 * strength, 0.5 * strength};
}

MohrCircle steady_circle(const YieldLocus& locus, const StressPoint& preshear) {
  const double phi = std::atan(locus.slope), sine = std::sin(phi), cosine = std::cos(phi);
  const double sigma = preshear.normal, tau = preshear.shear;
  // (sigma - s)^2 + tau^2 = (s sin phi + tau_0 cos phi)^2, a quadratic equation in s.
  const double a = cosine * cosine, half_b = sigma + locus.cohesion * sine * cosine;
  const double c = sigma * sigma + tau * tau - locus.cohesion * locus.cohesion * cosine * cosine;
  const double root = half_b * half_b - a * c;
  if (root >= 0) {
    const double centre = (half_b - std::sqrt(root)) / a;
    return {centre, centre * sine + locus.cohesion * cosine};
  }
  const double radius = locus.at(sigma) / cosine;
  return {sigma + radius * sine, radius};
}

double effective_angle(const MohrCircle& steady) {
  return std::asin(steady.radius / steady.centre) * 180 / std::numbers::pi;
}

double flow_function(const YieldLocus& locus, const StressPoint& preshear) {
  if (!(locus.cohesion > 0)) return kNone;
  return steady_circle(locus, preshear).major() / unconfined_circle(locus).major();
}

}  // namespace diefill::process::continuum
