#include "engine/simulation/sleeping.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace diefill::engine {

namespace {

/// Grains that must be tired before contacts are searched for their sake: a block's worth of spheres, or this
/// share of those awake where that is less. A search costs as much as several steps.
constexpr std::size_t kFewestSpheres = 1024, kFewestShare = 16;

/// Calls visit(i, j) for the grains of every touching pair in `block`; images stand for their owners.
template <class Visit>
void visit_touching(const Block& block, const SphereField& spheres, const Visit& visit) {
  const auto& table = block.grain_pairs;
  table.visit_touching([&](std::size_t p, const double*) {
    visit(spheres.owner(block.sphere(table.pair[p].own)), spheres.owner(block.sphere(table.pair[p].other)));
  });
}

bool in_any(const std::vector<Eigen::AlignedBox3d>& boxes, const Eigen::Vector3d& place) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const auto& box) { return box.contains(place); });
}

std::vector<std::uint32_t> places_of(const std::vector<std::uint8_t>& marks) {
  std::vector<std::uint32_t> places;
  for (std::uint32_t k = 0; k < marks.size(); ++k)
    if (marks[k]) places.push_back(k);
  return places;
}

}  // namespace

SleepSettings riding_on(std::size_t carrier) {
  SleepSettings settings;
  settings.energy = 0.05;  // a speed of 0.32 sqrt(g d)
  settings.time = 10e-3;
  settings.stray = 0.1;
  settings.force = 100;  // forces leap as the floor's bumps pass
  settings.speed = 3;
  settings.carrier = carrier;
  return settings;
}

Sleeping::Sleeping(const SleepSettings& settings, ParticleTypes kinds, const Eigen::Vector3d& gravity,
                   double time_step)
    : types_(std::move(kinds)) {
  if (!(settings.energy > 0 && settings.time > 0 && settings.force > 0 && settings.speed > 0 &&
        settings.acceleration > 0 && settings.stray >= 0))
    throw std::invalid_argument("limits of sleeping grains must be positive");
  set_gravity(settings, gravity);
  const double looks = std::ceil(settings.time / (time_step * static_cast<double>(kStepsPerLook)));
  looks_needed_ = static_cast<std::uint32_t>(std::clamp(looks, 1.0, 1e9));
}

void Sleeping::set_gravity(const SleepSettings& settings, const Eigen::Vector3d& gravity) {
  limits_.clear();
  for (std::size_t k = 0; k < types_.size(); ++k) {
    const GrainShape& shape = types_.shape(static_cast<TypeNumber>(k));
    const double weight = shape.mass * gravity.norm();
    const double slow_energy = settings.energy * weight * 2 * shape.bounding_radius();
    limits_.push_back({slow_energy, slow_energy * settings.speed * settings.speed, settings.force * weight,
                       settings.stray * 2 * shape.bounding_radius()});
  }
}

std::size_t Sleeping::sleepers() const {
  return static_cast<std::size_t>(std::count(state_.asleep.begin(), state_.asleep.end(), 1));
}

std::size_t Sleeping::reorder(std::vector<std::uint32_t>& order, std::size_t grains) {
  state_.asleep.resize(grains, 0);
  state_.looks.resize(grains, 0);
  state_.force.resize(grains, Eigen::Vector3d::Zero());
  if (limits_.front().stray > 0) state_.place.resize(grains, Eigen::Vector3d::Zero());
  const auto first_sleeper =
      std::stable_partition(order.begin(), order.end(), [&](std::uint32_t k) { return !asleep(k); });
  SleepState sorted;
  for (const std::uint32_t k : order) {
    sorted.asleep.push_back(state_.asleep[k]);
    sorted.looks.push_back(state_.looks[k]);
    sorted.force.push_back(state_.force[k]);
    if (!state_.place.empty()) sorted.place.push_back(state_.place[k]);
  }
  sorted.sphere_steps_left_out = state_.sphere_steps_left_out;
  state_ = std::move(sorted);
  return static_cast<std::size_t>(first_sleeper - order.begin());
}

void Sleeping::sort_blocks(const NeighbourList& list) {
  const auto& blocks = list.blocks();
  rests_.assign(blocks.size(), 0);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const auto first = state_.asleep.begin() + blocks[b].begin, last = state_.asleep.begin() + blocks[b].end;
    rests_[b] = std::all_of(first, last, [](auto mark) { return mark != 0; }) &&
                std::all_of(blocks[b].foreign.begin(), blocks[b].foreign.end(),
                            [&](std::uint32_t grain) { return asleep(grain); });
  }
}

void Sleeping::count_step(const NeighbourList& list) {
  for (std::size_t b = 0; b < rests_.size(); ++b)
    if (rests(b)) state_.sphere_steps_left_out += list.blocks()[b].own_spheres();
}

double Sleeping::kinetic_energy(const Grains& grains, std::size_t k, const Eigen::Vector3d& carried) const {
  const GrainShape& shape = types_.shape(grains.type_of(k));
  double energy = 0.5 * shape.mass * (grains.velocity[k] - carried).squaredNorm();
  if (shape.rotates) energy += 0.5 * shape.inertia.dot(grains.spin[k].cwiseAbs2());
  return energy;
}

/// Whether awake grain k is slow, and has got nowhere since it began to be.
void Sleeping::watch(const Grains& grains, std::size_t k, const BodyMotion& carrier) {
  const Limits& limits = limits_[grains.type_of(k)];
  bool slow = kinetic_energy(grains, k, carrier.velocity) < limits.slow_energy;
  if (slow && limits.stray > 0) {
    const Eigen::Vector3d place = grains.position[k] - carrier.translation;
    if (state_.looks[k] == 0) state_.place[k] = place;
    slow = (place - state_.place[k]).norm() < limits.stray;
  }
  state_.looks[k] = slow ? state_.looks[k] + 1 : 0;
}

void Sleeping::look(const Grains& grains, const BodyMotion& carrier) {
  for (std::size_t k = 0; k < grains.size(); ++k) {
    if (!asleep(k)) {
      watch(grains, k, carrier);
      continue;
    }
    if (state_.looks[k] == 0) state_.force[k] = grains.force[k];
    ++state_.looks[k];
  }
}

std::vector<std::uint32_t> Sleeping::disturbed(const Grains& grains, const Eigen::Vector3d& carried,
                                               const NeighbourList& list, const SphereField& spheres) const {
  std::vector<std::uint8_t> wakes(grains.size(), 0);
  for (std::size_t k = 0; k < grains.size(); ++k)
    wakes[k] =
        asleep(k) && (grains.force[k] - state_.force[k]).norm() > limits_[grains.type_of(k)].waking_force;
  for (std::size_t b = 0; b < list.blocks().size(); ++b) {
    if (rests(b)) continue;
    visit_touching(list.blocks()[b], spheres, [&](std::size_t i, std::size_t j) {
      if (asleep(i) == asleep(j)) return;
      const std::size_t sleeper = asleep(i) ? i : j, other = asleep(i) ? j : i;
      if (kinetic_energy(grains, other, carried) > limits_[grains.type_of(other)].waking_energy)
        wakes[sleeper] = 1;
    });
  }
  return places_of(wakes);
}

std::vector<std::uint32_t> Sleeping::within(const std::vector<Eigen::AlignedBox3d>& boxes,
                                            const Grains& grains) const {
  std::vector<std::uint32_t> found;
  if (boxes.empty()) return found;
  for (std::uint32_t k = 0; k < grains.size(); ++k)
    if (asleep(k) && in_any(boxes, grains.position[k])) found.push_back(k);
  return found;
}

void Sleeping::wake(const std::vector<std::uint32_t>& sleepers, const NeighbourList& list,
                    const SphereField& spheres) {
  if (sleepers.empty()) return;
  std::vector<std::uint8_t> wakes(state_.asleep.size(), 0), touched = wakes;
  for (const std::uint32_t k : sleepers) wakes[k] = touched[k] = 1;
  for (const auto& block : list.blocks())
    visit_touching(block, spheres, [&](std::size_t i, std::size_t j) {
      if (wakes[i]) touched[j] = 1;
      if (wakes[j]) touched[i] = 1;
    });
  for (std::size_t k = 0; k < touched.size(); ++k)
    if (touched[k] && asleep(k)) {
      state_.asleep[k] = 0;
      state_.looks[k] = 0;
    }
  sort_blocks(list);
}

void Sleeping::wake_all(const NeighbourList& list) {
  std::fill(state_.asleep.begin(), state_.asleep.end(), 0);
  std::fill(state_.looks.begin(), state_.looks.end(), 0);
  sort_blocks(list);
}

/// 1 for every awake grain that has been slow for long enough, away from tools that move, and every sleeper.
std::vector<std::uint8_t> Sleeping::calm(const Grains& grains,
                                         const std::vector<Eigen::AlignedBox3d>& moving) const {
  std::vector<std::uint8_t> calm(grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k)
    calm[k] = asleep(k) || (state_.looks[k] >= looks_needed_ && !in_any(moving, grains.position[k]));
  return calm;
}

std::vector<std::uint32_t> Sleeping::tired(const Grains& grains,
                                           const std::vector<Eigen::AlignedBox3d>& moving,
                                           const NeighbourList& list, const SphereField& spheres) const {
  const std::size_t asleep_now = sleepers(), awake = grains.size() - asleep_now;
  const std::size_t fewest =
      std::max<std::size_t>(1, std::min(awake / kFewestShare, kFewestSpheres / types_.spheres()));
  const auto slow = calm(grains, moving);
  if (static_cast<std::size_t>(std::count(slow.begin(), slow.end(), 1)) < asleep_now + fewest) return {};
  auto candidates = slow;
  for (const auto& block : list.blocks())
    visit_touching(block, spheres, [&](std::size_t i, std::size_t j) {
      if (!slow[i]) candidates[j] = 0;
      if (!slow[j]) candidates[i] = 0;
    });
  for (std::size_t k = 0; k < candidates.size(); ++k) candidates[k] = candidates[k] && !asleep(k);
  auto found = places_of(candidates);
  if (found.size() < fewest) found.clear();
  return found;
}

void Sleeping::put_to_sleep(const std::vector<std::uint32_t>& grains) {
  for (const std::uint32_t k : grains) {
    state_.asleep[k] = 1;
    state_.looks[k] = 0;
  }
}

}  // namespace diefill::engine
