#include "engine/limits/law_probe.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/limits/time_step.h"

namespace diefill::engine {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

laws::Reaction LawProbe::react(double overlap, Vector3 velocity, Vector3 spin, double time_step) const {
  History history{};
  laws::ContactState state;
  state.overlap = overlap;
  state.normal = {0, 0, 1};
  state.velocity = velocity;
  state.spin = spin;
  state.time_step = state.rolling_step = time_step;
  return law_.react(state, history.data());
}

double LawProbe::loading_force(double overlap) const {
  return react(overlap, {}, {}, 0).force.z;
}

double LawProbe::energy_of_approach() const {
  History history{};
  laws::ContactState touching;
  touching.normal = {0, 0, 1};
  touching.overlap = std::numeric_limits<double>::min();
  law_.react(touching, history.data());  // forms the bridge where there is one
  return -law_.attraction_energy(0, history.data());
}

double LawProbe::pull_at_touch() const {
  return -react(std::numeric_limits<double>::min(), {}, {}, 0).attraction;
}

/// J, work of the first approach to `overlap` (m): Simpson's rule after h = H u^2, which is smooth where
/// forces begin with a root.
double LawProbe::work_of_approach(double overlap) const {
  constexpr int kIntervals = 32;
  double sum = 0;
  for (int n = 1; n <= kIntervals; ++n) {
    const double u = static_cast<double>(n) / kIntervals;
    const double weight = n == kIntervals ? 1 : (n % 2 == 1 ? 4 : 2);
    sum += weight * loading_force(overlap * u * u) * 2 * overlap * u;
  }
  return sum / (3.0 * kIntervals);
}

double LawProbe::overlap_of_energy(double energy, double deepest) const {
  if (!(energy > 0)) return 0;
  double high = 1e-6 * deepest;
  while (high < deepest && work_of_approach(high) < energy) high = std::min(2 * high, deepest);
  double low = 0;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (low + high);
    (work_of_approach(middle) < energy ? low : high) = middle;
  }
  return high;
}

ContactSprings LawProbe::springs(double overlap) const {
  constexpr double kSlow = 1e-6, kShort = 1e-6;  // m/s or rad/s, s: far below any limit of friction
  const Vector3 along = {kSlow, 0, 0};
  const double slid = react(overlap, along, {}, kShort).force.x,
               dragged = react(overlap, along, {}, 0).force.x;
  const double rolled = react(overlap, {}, along, kShort).torque.x - react(overlap, {}, along, 0).torque.x;
  ContactSprings springs;
  springs.normal = law_.stiffness(overlap);
  springs.tangential = (dragged - slid) / (kSlow * kShort);
  springs.rolling = law_.parts().rolling.follows_time_step() ? 0 : -rolled / (kSlow * kShort);
  springs.damping = law_.damping(overlap);
  springs.sliding_damping = -dragged / kSlow;
  return springs;
}

ContactMasses masses_of(const GrainShape& shape) {
  const double turning =
      shape.rotates ? 1 + std::pow(shape.bounding_radius(), 2) * shape.mass / shape.inertia.minCoeff() : 1;
  return {shape.mass / mobility(shape), shape.mass / turning,
          shape.rotates ? shape.inertia.minCoeff() : kInfinite};
}

ContactMasses reduced(const ContactMasses& one, const ContactMasses& other) {
  const auto of = laws::PairProperties::reduced;
  return {of(one.normal, other.normal), of(one.sliding, other.sliding), of(one.inertia, other.inertia)};
}

ContactMasses half_of_smaller(const ContactMasses& one, const ContactMasses& other) {
  return {0.5 * std::min(one.normal, other.normal), 0.5 * std::min(one.sliding, other.sliding),
          0.5 * std::min(one.inertia, other.inertia)};
}

double step_limit(const ContactSprings& springs, const ContactMasses& masses, double contacts) {
  double step = kInfinite;
  const auto spring = [&](double of, double stiffness) {
    if (stiffness > 0) step = std::min(step, 2 * std::sqrt(of / (contacts * stiffness)));
  };
  const auto damper = [&](double of, double coefficient) {
    if (coefficient > 0) step = std::min(step, 2 * of / (contacts * coefficient));
  };
  spring(masses.normal, springs.normal);
  spring(masses.sliding, springs.tangential);
  spring(masses.inertia, springs.rolling);
  damper(masses.normal, springs.damping);
  damper(masses.sliding, springs.sliding_damping);
  return step;
}

double crossing_time(const LawProbe& probe, double mass) {
  const double energy = probe.energy_of_approach();
  if (!(energy > 0)) return kInfinite;
  return energy / probe.pull_at_touch() / (1.5 * std::sqrt(2 * energy / mass));
}

}  // namespace diefill::engine
