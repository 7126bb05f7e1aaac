#include "engine/general_time_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/pinching_contacts.h"
#include "engine/stable_step.h"
#include "engine/time_step.h"

namespace diefill::engine {

namespace {

using coarse_graining::ForceScaling;
using laws::GeneralLaw;
using laws::PairProperties;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Springs and dampers of a pair at one overlap.
struct Springs {
  double normal = 0, tangential = 0;        ///< N/m
  double rolling = 0;                       ///< N m per radian
  double damping = 0, sliding_damping = 0;  ///< kg/s
};

/// The law of one pair, asked for numbers instead of stepped through time.
class Probe {
 public:
  Probe(const laws::LawParameters& parameters, const ForceScaling& scaling, const PairProperties& pair)
      : law_(laws::make_law(parameters, scaling.original(pair))), scaled_(scaling, law_) {}

  /// N, of a first approach to `overlap` (m), damping left out.
  double loading_force(double overlap) const { return react(overlap, {}, {}, 0).force.z; }

  /// J that the attraction has given to a pair when it comes to touch.
  double energy_of_approach() const {
    Memory memory{};
    laws::ContactState touching;
    touching.normal = {0, 0, 1};
    touching.overlap = std::numeric_limits<double>::min();
    scaled_.react(touching, memory.data());  // forms the bridge where there is one
    return -scaled_.attraction_energy(0, memory.data());
  }

  /// N, of the attraction where the pair comes to touch.
  double pull_at_touch() const { return -react(std::numeric_limits<double>::min(), {}, {}, 0).attraction; }

  Springs springs(double overlap) const {
    constexpr double kSlow = 1e-6, kShort = 1e-6;  // m/s or rad/s, s: far below any limit of friction
    const Vector3 along = {kSlow, 0, 0};
    const double slid = react(overlap, along, {}, kShort).force.x,
                 dragged = react(overlap, along, {}, 0).force.x;
    const double rolled = react(overlap, {}, along, kShort).couple.x - react(overlap, {}, along, 0).couple.x;
    Springs springs;
    springs.normal = scaled_.stiffness(overlap);
    springs.tangential = (dragged - slid) / (kSlow * kShort);
    springs.rolling = -rolled / (kSlow * kShort);
    springs.damping = std::abs(react(overlap, {0, 0, 1}, {}, 0).viscous);
    springs.sliding_damping = -dragged / kSlow;
    return springs;
  }

 private:
  using Memory = std::array<double, static_cast<std::size_t>(GeneralLaw::kMemory)>;

  laws::Reaction react(double overlap, Vector3 velocity, Vector3 spin, double time_step) const {
    Memory memory{};
    laws::ContactState state;
    state.overlap = overlap;
    state.normal = {0, 0, 1};
    state.velocity = velocity;
    state.spin = spin;
    state.time_step = state.rolling_step = time_step;
    return scaled_.react(state, memory.data());
  }

  GeneralLaw law_;
  coarse_graining::ScaledLaw<GeneralLaw> scaled_;
};

PairProperties grain_pair(const GrainShape& shape) {
  return {shape.sphere_radius, shape.sphere_radius, shape.mass, shape.mass};
}

PairProperties wall_pair(const GrainShape& shape, double wall_radius) {
  return {shape.sphere_radius, wall_radius, shape.mass, kInfinite};
}

/// s: of `contacts` such contacts on `mass` (kg) and `inertia` (kg m^2) at once; both reduced.
double limit_of(const Springs& springs, const GrainShape& shape, double mass, double inertia,
                double contacts) {
  const double turning =
      shape.rotates ? 1 + std::pow(shape.bounding_radius(), 2) * shape.mass / shape.inertia.minCoeff() : 1;
  double step = kInfinite;
  const auto spring = [&](double of, double stiffness) {
    if (stiffness > 0) step = std::min(step, 2 * std::sqrt(of / (contacts * stiffness)));
  };
  const auto damper = [&](double of, double coefficient) {
    if (coefficient > 0) step = std::min(step, 2 * of / (contacts * coefficient));
  };
  spring(mass / mobility(shape), springs.normal);
  spring(mass / turning, springs.tangential);
  if (shape.rotates) spring(inertia, springs.rolling);
  damper(mass / mobility(shape), springs.damping);
  damper(mass / turning, springs.sliding_damping);
  return step;
}

/// J, work of the first approach to `overlap` (m): Simpson's rule after h = H u^2, which is smooth where
/// forces begin with a root.
double work_of_approach(const Probe& probe, double overlap) {
  constexpr int kIntervals = 32;
  double sum = 0;
  for (int n = 1; n <= kIntervals; ++n) {
    const double u = static_cast<double>(n) / kIntervals;
    const double weight = n == kIntervals ? 1 : (n % 2 == 1 ? 4 : 2);
    sum += weight * probe.loading_force(overlap * u * u) * 2 * overlap * u;
  }
  return sum / (3.0 * kIntervals);
}

/// m: where the work of approach has used up `energy` (J), at most `deepest` (m).
double overlap_of_energy(const Probe& probe, double energy, double deepest) {
  if (!(energy > 0)) return 0;
  double high = 1e-6 * deepest;
  while (high < deepest && work_of_approach(probe, high) < energy) high = std::min(2 * high, deepest);
  double low = 0;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (low + high);
    (work_of_approach(probe, middle) < energy ? low : high) = middle;
  }
  return high;
}

double collision_overlap(const Probe& probe, double mass, double speed, double deepest) {
  return overlap_of_energy(probe, 0.5 * mass * speed * speed + probe.energy_of_approach(), deepest);
}

/// s that a pair at 1.5 times the speed of escape takes to cross the steep part of its attraction, energy
/// over force: longer steps jump over it (STABILITY.md, van der Waals cut-offs).
double crossing_time(const Probe& probe, double mass) {
  const double energy = probe.energy_of_approach();
  if (!(energy > 0)) return kInfinite;
  return energy / probe.pull_at_touch() / (1.5 * std::sqrt(2 * energy / mass));
}

/// s: of a collision and of a packing, for a pair of reduced mass and moment of inertia.
double critical_of_pair(const Probe& probe, const GrainShape& shape, double mass, double inertia,
                        double speed) {
  const double overlap = collision_overlap(probe, mass, speed, shape.sphere_radius);
  const double impact = limit_of(probe.springs(overlap), shape, mass, inertia, 1);
  // Many contacts share what damping there is: their springs alone, as in time_step.h.
  Springs packed = probe.springs(0.1 * overlap);
  packed.damping = packed.sliding_damping = 0;
  return std::min(
      {impact, limit_of(packed, shape, mass, inertia, kContactsPerGrain), crossing_time(probe, mass)});
}

}  // namespace

double impact_overlap(const GrainShape& shape, const GeneralContact& contact, double impact_speed) {
  const Probe probe(contact.grains, contact.scaling, grain_pair(shape));
  return collision_overlap(probe, 0.5 * shape.mass, impact_speed, shape.sphere_radius);
}

double critical_time_step(const GrainShape& shape, const GeneralContact& contact, double impact_speed) {
  const double inertia = shape.inertia.minCoeff();
  const Probe grains(contact.grains, contact.scaling, grain_pair(shape));
  const Probe walls(contact.walls, contact.scaling, wall_pair(shape, kInfinite));
  return std::min(critical_of_pair(grains, shape, 0.5 * shape.mass, 0.5 * inertia, impact_speed),
                  critical_of_pair(walls, shape, shape.mass, inertia, impact_speed));
}

double critical_time_step_at_overlap(const GrainShape& shape, const GeneralContact& contact, double overlap) {
  const Probe probe(contact.grains, contact.scaling, grain_pair(shape));
  return limit_of(probe.springs(overlap), shape, 0.5 * shape.mass, 0.5 * shape.inertia.minCoeff(), 1);
}

double pinch_time_step(const GrainShape& shape, const GeneralContact& contact, double wall_radius,
                       double wall_spacing, double overlap) {
  const Probe probe(contact.walls, contact.scaling, wall_pair(shape, wall_radius));
  const double contacts = pinching_contacts(shape.sphere_radius, wall_radius, wall_spacing, overlap);
  // Coulomb's limit holds the others, as a pinched sphere slides.
  const Springs springs = probe.springs(overlap);
  return stable_step(shape.mass / mobility(shape), contacts * springs.normal, contacts * springs.damping);
}

}  // namespace diefill::engine
