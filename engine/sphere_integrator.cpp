#include "engine/sphere_integrator.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace diefill::engine {

namespace {

/// The numbers of vectors that lie one behind the other.
double* numbers(std::vector<Eigen::Vector3d>& vectors) {
  return vectors.data()->data();
}

}  // namespace

/// The sums of a chunk of spheres, taken apart, and what the air does to them.
struct SphereIntegrator::ContactForces {
  // Longer than a chunk by what the last sphere's copy reaches beyond it.
  alignas(64) double force[3 * kChunk + 1];      ///< N
  alignas(64) double moment[3 * kChunk + 1];     ///< N m
  alignas(64) double drag_power[kNumbers] = {};  ///< W, summed up over all chunks, number by number

  /// Four numbers at a time, of which the next sphere overwrites the last.
  void take(std::span<const ContactSum> sums) {
    for (std::size_t k = 0; k < sums.size(); ++k) {
      Four half;
      load(half, sums[k].first_half());
      store(half, force + 3 * k);
      load(half, sums[k].second_half());
      store(half, moment + 3 * k);
    }
  }
  double total_drag_power() const {
    double sum = 0;
    for (const double power : drag_power) sum += power;
    return sum;
  }
};

SphereIntegrator::SphereIntegrator(std::vector<Body> bodies, bool rotates, bool rolls, double time_step,
                                   InstructionSet instructions)
    : bodies_(std::move(bodies)),
      rotates_(rotates),
      rolls_(rotates && rolls),
      time_step_(time_step),
      instructions_(instructions) {
  for (std::size_t sphere = 0; sphere < kSpheres; ++sphere) set(alike_, sphere, bodies_.front());
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
    if (bodies_.size() == 1) return alike_;
    for (std::size_t sphere = 0; sphere < count; ++sphere)
      set(mixed, sphere, bodies_[grains.kind[first + sphere]]);
    return mixed;
  };
  std::size_t first = begin;
  for (; first + kSpheres <= end; first += kSpheres)
    visit(factors(first, kSpheres), 3 * first, std::integral_constant<std::size_t, kNumbers>{});
  if (first < end) visit(factors(first, end - first), 3 * first, 3 * (end - first));
}

void SphereIntegrator::advance(Grains& grains, std::size_t begin, std::size_t end) const {
  double *position = numbers(grains.position), *velocity = numbers(grains.velocity),
         *spin = numbers(grains.spin);
  const double *force = numbers(grains.force), *torque = numbers(grains.torque);
  const double time_step = time_step_;
  with_instructions(instructions_, [&] {
    for_groups(grains, begin, end, [&](const Factors& factors, std::size_t first, auto how_many) {
      const std::size_t count = how_many;
#pragma GCC ivdep
      for (std::size_t k = 0; k < count; ++k) {
        const double gained = factors.velocity_per_force[k] * force[first + k];
        position[first + k] += time_step * (velocity[first + k] + 0.5 * gained);
        velocity[first + k] += gained;
      }
      if (!rotates_) return;
#pragma GCC ivdep
      for (std::size_t k = 0; k < count; ++k)
        spin[first + k] += factors.spin_per_torque[k] * torque[first + k];
    });
  });
}

StepWork SphereIntegrator::finish(Grains& grains, std::size_t begin, std::size_t end,
                                  std::span<const ContactSum> contacts) const {
  ContactForces chunk;
  double rolling_power = 0;
  for (std::size_t first = begin; first < end; first += kChunk) {
    const std::size_t last = std::min(end, first + kChunk);
    const auto sums = contacts.subspan(first - begin, last - first);
    with_instructions(instructions_, [&] {
      chunk.take(sums);
      kick(grains, first, last, chunk);
      if (rotates_) kick_spin(grains, first, last, chunk);
    });
    if (rolls_) rolling_power += slow_rolling(grains, sums, first);
  }
  return {chunk.total_drag_power() * time_step_, rolling_power * time_step_};
}

/// From the velocities that the forces before the step lead to, those that the mean of the forces before and
/// after it does: contacts, air, weight.
void SphereIntegrator::kick(Grains& grains, std::size_t begin, std::size_t end,
                            ContactForces& contacts) const {
  double *velocity = numbers(grains.velocity), *force = numbers(grains.force), *power = contacts.drag_power;
  const double* contact = contacts.force;
  for_groups(grains, begin, end, [&](const Factors& factors, std::size_t first, auto how_many) {
    const std::size_t count = how_many;
    const double* acting = contact + (first - 3 * begin);
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
}

/// The same for spins and torques.
void SphereIntegrator::kick_spin(Grains& grains, std::size_t begin, std::size_t end,
                                 const ContactForces& contacts) const {
  double *spin = numbers(grains.spin), *torque = numbers(grains.torque);
  for_groups(grains, begin, end, [&](const Factors& factors, std::size_t first, auto how_many) {
    const std::size_t count = how_many;
    const double* acting = contacts.moment + (first - 3 * begin);
#pragma GCC ivdep
    for (std::size_t k = 0; k < count; ++k) {
      spin[first + k] += 0.5 * factors.spin_per_torque[k] * (acting[k] - torque[first + k]);
      torque[first + k] = acting[k];
    }
  });
}

/// Slows spins by rolling friction (Bierwisch 2009, Eq. 2.11), which stops a rotation but never reverses it
/// within a step (OP-9). Returns its power (W).
double SphereIntegrator::slow_rolling(Grains& grains, std::span<const ContactSum> contacts,
                                      std::size_t begin) const {
  double power = 0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    Eigen::Vector3d& spin = grains.spin[begin + k];
    const double inertia = bodies_[grains.kind_of(begin + k)].inertia, speed = spin.norm();
    const double slower = std::max(0.0, speed - contacts[k].rolling_load() * time_step_ / inertia);
    power += 0.5 * inertia * (slower * slower - speed * speed) / time_step_;
    if (speed > 0) spin *= slower / speed;
  }
  return power;
}

}  // namespace diefill::engine
