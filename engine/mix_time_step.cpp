#include "engine/mix_time_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/pair_laws.h"
#include "engine/time_step.h"

namespace diefill::engine {

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// m, at which the law has taken up `energy` (J): bisection between 0 and where it holds more.
double overlap_of_energy(const laws::GeneralContactLaw& law, double energy, double radius) {
  double low = 0, high = 1e-3 * radius;
  for (int k = 0; k < 60 && law.fresh_energy(high) < energy; ++k) high *= 2;
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (law.fresh_energy(middle) < energy ? low : high) = middle;
  }
  return high;
}

/// s, 2 sqrt(m / k), without limit where there is no stiffness.
double oscillator(double mass, double stiffness) {
  return stiffness > 0 ? 2 * std::sqrt(mass / stiffness) : kNoLimit;
}

/// s, at `overlap` (m), of one contact on which `mobile_mass` (kg) moves, and of kContactsPerGrain at a tenth
/// of the overlap on a grain of `lightest` (kg).
double shortest_at(const laws::GeneralContactLaw& law, double overlap, double mobile_mass, double lightest) {
  const double damping = law.damping(overlap);
  const double impact = oscillator(mobile_mass, law.stiffness(overlap));
  const double damper = damping > 0 ? 2 * mobile_mass / damping : kNoLimit;
  const double packed = oscillator(lightest, 2 * kContactsPerGrain * law.stiffness(0.1 * overlap));
  return std::min({impact, damper, packed});
}

/// The same at an impact at `impact_speed` (m/s) of effective mass `mass` (kg).
double shortest(const laws::GeneralContactLaw& law, double radius, double mass, double mobile_mass,
                double lightest, double impact_speed) {
  const double overlap = overlap_of_energy(law, 0.5 * mass * impact_speed * impact_speed, radius);
  return shortest_at(law, overlap, mobile_mass, lightest);
}

double mobile_mass_of(const GrainShape& shape) {
  return shape.mass / mobility(shape);
}

/// The kinds with moments of inertia as torques balance with.
KindTable moving_kinds(const GrainMix& mix) {
  auto moving = mix.kinds;
  for (auto& kind : moving) kind.shape.inertia /= mix.scaling.torque_factor();
  return KindTable(std::move(moving));
}

}  // namespace

double critical_time_step(const GrainMix& mix, const std::vector<MixWall>& walls, double impact_speed) {
  const KindTable kinds = moving_kinds(mix);
  const auto count = static_cast<KindNumber>(kinds.size());
  double critical = kNoLimit;
  for (KindNumber i = 0; i < count; ++i) {
    const GrainShape& one = kinds.shape(i);
    const double mobile = mobile_mass_of(one);
    for (KindNumber j = i; j < count; ++j) {
      const GrainShape& other = kinds.shape(j);
      const double radius = std::min(one.sphere_radius, other.sphere_radius);
      const double other_mobile = mobile_mass_of(other);
      critical = std::min(critical, shortest(law_of_kinds(kinds, mix, i, j), radius,
                                             laws::PairProperties::reduced(one.mass, other.mass),
                                             laws::PairProperties::reduced(mobile, other_mobile),
                                             std::min(mobile, other_mobile), impact_speed));
    }
    for (const auto& wall : walls)
      critical = std::min(critical, shortest(law_with_wall(kinds, mix, i, wall.material, wall.sphere_radius),
                                             one.sphere_radius, one.mass, mobile, kNoLimit, impact_speed));
  }
  return critical;
}

double critical_time_step_at_overlap(const GrainMix& mix, double overlap, double overlap_over_radius) {
  const KindTable kinds = moving_kinds(mix);
  const auto count = static_cast<KindNumber>(kinds.size());
  double critical = kNoLimit;
  for (KindNumber i = 0; i < count; ++i)
    for (KindNumber j = i; j < count; ++j) {
      const GrainShape &one = kinds.shape(i), &other = kinds.shape(j);
      const double radius = std::min(one.sphere_radius, other.sphere_radius);
      const double mobile = mobile_mass_of(one), other_mobile = mobile_mass_of(other);
      critical = std::min(
          critical,
          shortest_at(law_of_kinds(kinds, mix, i, j), std::min(overlap, overlap_over_radius * radius),
                      laws::PairProperties::reduced(mobile, other_mobile), std::min(mobile, other_mobile)));
    }
  return critical;
}

}  // namespace diefill::engine
