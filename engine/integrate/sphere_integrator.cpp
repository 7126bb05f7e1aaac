#include "engine/integrate/sphere_integrator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "engine/numerics/prefetch.h"

namespace diefill::engine {

namespace {

/// The numbers of vectors that lie one after the other.
double* numbers(std::vector<Eigen::Vector3d>& vectors) {
  return vectors.data()->data();
}

}  // namespace

SphereIntegrator::SphereIntegrator(std::vector<Body> bodies, bool rotates, bool rolls, double time_step,
                                   InstructionSet instructions)
    : bodies_(std::move(bodies)),
      rotates_(rotates),
      rolls_(rotates && rolls),
      time_step_(time_step),
      instructions_(instructions) {
  for (std::size_t sphere = 0; sphere < kSpheres; ++sphere) set(monodisperse_, sphere, bodies_.front());
}

void SphereIntegrator::set(Factors& factors, std::size_t sphere, const Body& body) const {
  const double weight[] = {body.weight.x, body.weight.y, body.weight.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t number = 3 * sphere + axis;
    factors.velocity_per_force[number] = time_step_ / body.mass;
    factors.spin_per_torque[number] = rotates_ ? time_step_ / body.inertia : 0;
    factors.drag[number] = body.drag;
    factors.weight[number] = weight[axis];
  }
}

/// Calls visit(factors, first number, how many) for a few spheres at a time; `how many` is known to the
/// compiler for all groups but the last.
template <class Visit>
void SphereIntegrator::for_groups(const Grains& grains, std::size_t begin, std::size_t end,
                                  const Visit& visit) const {
  Factors mixed;
  const auto factors = [&](std::size_t first, std::size_t count) -> const Factors& {
    if (bodies_.size() == 1) return monodisperse_;
    for (std::size_t sphere = 0; sphere < count; ++sphere)
      set(mixed, sphere, bodies_[grains.kind[first + sphere]]);
    return mixed;
  };
  std::size_t first = begin;
  for (; first + kSpheres <= end; first += kSpheres)
    visit(factors(first, kSpheres), 3 * first, std::integral_constant<std::size_t, kNumbers>{});
  if (first < end) visit(factors(first, end - first), 3 * first, 3 * (end - first));
}

double SphereIntegrator::advance(Grains& grains, std::size_t begin, std::size_t end,
                                 const Vector3& drifted) const {
  double *position = numbers(grains.position), *velocity = numbers(grains.velocity),
         *spin = numbers(grains.spin);
  const double *force = numbers(grains.force), *torque = numbers(grains.torque);
  const double time_step = time_step_;
  alignas(64) double against[kNumbers], farthest[kNumbers] = {};  // m, along the axis of each number
  for (std::size_t k = 0; k < kNumbers; ++k) against[k] = std::array{drifted.x, drifted.y, drifted.z}[k % 3];
  with_instructions(instructions_, [&] {
    for_groups(grains, begin, end, [&](const Factors& factors, std::size_t first, auto how_many) {
      const std::size_t count = how_many;
      prefetch<kSpheres>(first / 3, grains.position, grains.velocity, grains.force);
      if (rotates_) prefetch<kSpheres>(first / 3, grains.spin, grains.torque);
#pragma GCC ivdep
      for (std::size_t k = 0; k < count; ++k) {
        const double gained = factors.velocity_per_force[k] * force[first + k];
        const double way = time_step * (velocity[first + k] + 0.5 * gained);
        position[first + k] += way;
        velocity[first + k] += gained;
        const double moved = std::abs(way - against[k]);
        farthest[k] = moved > farthest[k] ? moved : farthest[k];
      }
      if (!rotates_) return;
#pragma GCC ivdep
      for (std::size_t k = 0; k < count; ++k)
        spin[first + k] += factors.spin_per_torque[k] * torque[first + k];
    });
  });
  Eigen::Vector3d most = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < kNumbers; ++k) {
    double& along = most[static_cast<Eigen::Index>(k % 3)];
    along = std::max(along, farthest[k]);
  }
  return most.norm();
}

StepWork SphereIntegrator::finish(Grains& grains, std::size_t begin, std::size_t end,
                                  const ContactSums& contacts, std::size_t first_sum) const {
  StepWork power;  // W
  with_instructions(instructions_, [&] {
    power.drag = kick(grains, begin, end, contacts.forces() + 3 * first_sum);
    if (rotates_) kick_spin(grains, begin, end, contacts.moments() + 3 * first_sum);
  });
  if (rolls_) power.rolling = slow_rolling(grains, begin, end, contacts.loads() + first_sum);
  return {power.drag * time_step_, power.rolling * time_step_};
}

/// From the velocities that the forces before the step lead to, those that the mean of the forces before and
/// after it does: contacts (N, three numbers per sphere), air, weight. Returns the power of the air (W).
double SphereIntegrator::kick(Grains& grains, std::size_t begin, std::size_t end,
                              const double* contact_forces) const {
  double *velocity = numbers(grains.velocity), *force = numbers(grains.force);
  alignas(64) double power[kNumbers] = {};  // summed up number by number
  for_groups(grains, begin, end, [&](const Factors& factors, std::size_t first, auto how_many) {
    const std::size_t count = how_many;
    const double* acting = contact_forces + (first - 3 * begin);
    prefetch<kSpheres>(first / 3, grains.velocity, grains.force);
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
      const double predicted = velocity[first + k];
      const double air = -factors.drag[k] * predicted;
      const double after = acting[k] + air + factors.weight[k];
      power[k] += air * predicted;
      velocity[first + k] += 0.5 * factors.velocity_per_force[k] * (after - force[first + k]);
      force[first + k] = after;
    }
  });
  double sum = 0;
  for (const double part : power) sum += part;
  return sum;
}

/// The same for spins and torques; moments of contacts in N m.
void SphereIntegrator::kick_spin(Grains& grains, std::size_t begin, std::size_t end,
                                 const double* contact_moments) const {
  double *spin = numbers(grains.spin), *torque = numbers(grains.torque);
  for_groups(grains, begin, end, [&](const Factors& factors, std::size_t first, auto how_many) {
    const std::size_t count = how_many;
    const double* acting = contact_moments + (first - 3 * begin);
    prefetch<kSpheres>(first / 3, grains.spin, grains.torque);
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
      spin[first + k] += 0.5 * factors.spin_per_torque[k] * (acting[k] - torque[first + k]);
      torque[first + k] = acting[k];
    }
  });
}

/// Slows spins by rolling friction (Bierwisch 2009, Eq. 2.11), which stops a rotation but never reverses it
/// within a step (OP-9). `loads` in N m, one per sphere. Returns its power (W).
double SphereIntegrator::slow_rolling(Grains& grains, std::size_t begin, std::size_t end,
                                      const double* loads) const {
  double power = 0;
  for (std::size_t k = begin; k < end; ++k) {
    Eigen::Vector3d& spin = grains.spin[k];
    const double inertia = bodies_[grains.type_of(k)].inertia, speed = spin.norm();
    const double slower = std::max(0.0, speed - loads[k - begin] * time_step_ / inertia);
    power += 0.5 * inertia * (slower * slower - speed * speed) / time_step_;
    if (speed > 0) spin *= slower / speed;
  }
  return power;
}

}  // namespace diefill::engine
