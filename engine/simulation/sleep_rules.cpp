#include "engine/simulation/sleep_rules.h"

#include <algorithm>
#include <cmath>

namespace diefill::engine {

namespace {

/// Grains that must be candidates before contacts are searched for their sake: a block's worth of spheres, or
/// this share of those awake where that is less. A search costs as much as several steps.
constexpr std::size_t kMinSpheres = 1024, kMinShare = 16;

/// When a grain of one type is slow, and what wakes it or those it touches.
struct Limits {
  double slow_energy, waking_energy;  ///< J
  double waking_force;                ///< N
  double stray;                       ///< m; 0: none
};

/// One a type: they follow the weight of the grains.
std::vector<Limits> limits_of_types(const SimulationState& state) {
  const SleepSettings& settings = *state.settings.sleep;
  std::vector<Limits> limits;
  for (std::size_t k = 0; k < state.types.size(); ++k) {
    const GrainShape& shape = state.types.shape(static_cast<TypeNumber>(k));
    const double weight = shape.mass * state.settings.gravity.norm();
    const double slow_energy = settings.energy * weight * 2 * shape.bounding_radius();
    limits.push_back({slow_energy, slow_energy * settings.speed * settings.speed, settings.force * weight,
                      settings.stray * 2 * shape.bounding_radius()});
  }
  return limits;
}

/// Looks in a row at which a grain must have been slow.
std::uint32_t looks_needed(const SimulationState& state) {
  const double between = state.settings.time_step * static_cast<double>(kStepsPerCheck);
  return static_cast<std::uint32_t>(std::clamp(std::ceil(state.settings.sleep->time / between), 1.0, 1e9));
}

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

/// Whether awake grain k is slow, and has got nowhere since it began to be.
void watch(SimulationState& state, std::size_t k, const Limits& limits, const BodyMotion& carrier) {
  SleepState& sleep = state.sleep;
  bool slow = kinetic_energy(state, k, carrier.velocity) < limits.slow_energy;
  if (slow && limits.stray > 0) {
    const Eigen::Vector3d place = state.grains.position[k] - carrier.translation;
    if (sleep.checks[k] == 0) sleep.place[k] = place;
    slow = (place - sleep.place[k]).norm() < limits.stray;
  }
  sleep.checks[k] = slow ? sleep.checks[k] + 1 : 0;
}

/// 1 for every awake grain that has been slow for long enough, away from tools that move, and every sleeper.
std::vector<std::uint8_t> slow_long_enough(const SimulationState& state,
                                           const std::vector<Eigen::AlignedBox3d>& near_moving_tools) {
  const std::uint32_t needed = looks_needed(state);
  std::vector<std::uint8_t> slow(state.grains.size());
  for (std::size_t k = 0; k < slow.size(); ++k)
    slow[k] = state.sleep.sleeps(k) ||
              (state.sleep.checks[k] >= needed && !in_any(near_moving_tools, state.grains.position[k]));
  return slow;
}

}  // namespace

BodyMotion carrier_motion(const SimulationState& state) {
  const auto& carrier = state.settings.sleep->carrier;
  return carrier ? state.body_motion[*carrier] : BodyMotion{};
}

std::vector<Eigen::AlignedBox3d> moving_tools(const SimulationState& state) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    const WallBody& body = state.bodies[b];
    const BodyMotion &now = state.body_motion[b], &then = state.reference.bodies[b];
    if (now.velocity.isZero(0) && now.angular_velocity.isZero(0) && now.rotation == then.rotation &&
        now.translation == then.translation)
      continue;
    if (state.settings.sleep->carrier == b) continue;
    const Eigen::Vector3d lower = body.lower(), upper = body.upper();
    const Eigen::Vector3d middle = now.point(0.5 * (lower + upper));
    const Eigen::Vector3d half =
        now.rotation.cwiseAbs() * (0.5 * (upper - lower)) +
        Eigen::Vector3d::Constant(body.sphere_radius() + 2 * state.types.largest_grain());
    boxes.emplace_back(middle - half, middle + half);
  }
  return boxes;
}

double kinetic_energy(const SimulationState& state, std::size_t k, const Eigen::Vector3d& carried) {
  const GrainShape& shape = state.shape_of(k);
  double energy = 0.5 * shape.mass * (state.grains.velocity[k] - carried).squaredNorm();
  if (shape.rotates) energy += 0.5 * shape.inertia.dot(state.grains.spin[k].cwiseAbs2());
  return energy;
}

void check_grains(SimulationState& state) {
  const auto limits = limits_of_types(state);
  const BodyMotion carrier = carrier_motion(state);
  SleepState& sleep = state.sleep;
  for (std::size_t k = 0; k < state.grains.size(); ++k) {
    if (!sleep.sleeps(k)) {
      watch(state, k, limits[state.grains.type_of(k)], carrier);
      continue;
    }
    if (sleep.checks[k] == 0) sleep.force[k] = state.grains.force[k];
    ++sleep.checks[k];
  }
}

std::vector<std::uint32_t> disturbed(const SimulationState& state, const std::vector<std::uint8_t>& rests) {
  const auto limits = limits_of_types(state);
  const Eigen::Vector3d carried = carrier_motion(state).velocity;
  const Grains& grains = state.grains;
  const SleepState& sleep = state.sleep;
  std::vector<std::uint8_t> wakes(grains.size(), 0);
  for (std::size_t k = 0; k < grains.size(); ++k)
    wakes[k] =
        sleep.sleeps(k) && (grains.force[k] - sleep.force[k]).norm() > limits[grains.type_of(k)].waking_force;
  for (std::size_t b = 0; b < rests.size(); ++b) {
    if (rests[b]) continue;
    visit_touching(state.list.blocks()[b], state.spheres, [&](std::size_t i, std::size_t j) {
      if (sleep.sleeps(i) == sleep.sleeps(j)) return;
      const std::size_t sleeper = sleep.sleeps(i) ? i : j, other = sleep.sleeps(i) ? j : i;
      if (kinetic_energy(state, other, carried) > limits[grains.type_of(other)].waking_energy)
        wakes[sleeper] = 1;
    });
  }
  return places_of(wakes);
}

std::vector<std::uint32_t> sleepers_within(const SimulationState& state,
                                           const std::vector<Eigen::AlignedBox3d>& boxes) {
  std::vector<std::uint32_t> found;
  if (boxes.empty()) return found;
  for (std::uint32_t k = 0; k < state.grains.size(); ++k)
    if (state.sleep.sleeps(k) && in_any(boxes, state.grains.position[k])) found.push_back(k);
  return found;
}

void wake(SimulationState& state, const std::vector<std::uint32_t>& sleepers) {
  std::vector<std::uint8_t> wakes(state.grains.size(), 0);
  for (const std::uint32_t k : sleepers) wakes[k] = 1;
  auto touched = wakes;
  for (const auto& block : state.list.blocks())
    visit_touching(block, state.spheres, [&](std::size_t i, std::size_t j) {
      if (wakes[i]) touched[j] = 1;
      if (wakes[j]) touched[i] = 1;
    });
  for (std::size_t k = 0; k < touched.size(); ++k)
    if (touched[k] && state.sleep.sleeps(k)) state.sleep.wake(k);
}

std::vector<std::uint32_t> sleep_candidates(const SimulationState& state,
                                            const std::vector<Eigen::AlignedBox3d>& near_moving_tools) {
  const std::size_t asleep_now = state.sleep.sleepers(), awake = state.grains.size() - asleep_now;
  const std::size_t fewest =
      std::max<std::size_t>(1, std::min(awake / kMinShare, kMinSpheres / state.types.spheres()));
  const auto slow = slow_long_enough(state, near_moving_tools);
  if (static_cast<std::size_t>(std::count(slow.begin(), slow.end(), 1)) < asleep_now + fewest) return {};
  auto candidates = slow;
  for (const auto& block : state.list.blocks())
    visit_touching(block, state.spheres, [&](std::size_t i, std::size_t j) {
      if (!slow[i]) candidates[j] = 0;
      if (!slow[j]) candidates[i] = 0;
    });
  for (std::size_t k = 0; k < candidates.size(); ++k) candidates[k] = candidates[k] && !state.sleep.sleeps(k);
  auto found = places_of(candidates);
  if (found.size() < fewest) found.clear();
  return found;
}

std::vector<std::uint8_t> blocks_at_rest(const SimulationState& state) {
  const auto& blocks = state.list.blocks();
  const SleepState& sleep = state.sleep;
  std::vector<std::uint8_t> rests(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    bool all = true;
    for (std::size_t k = blocks[b].begin; all && k < blocks[b].end; ++k) all = sleep.sleeps(k);
    rests[b] = all && std::all_of(blocks[b].foreign.begin(), blocks[b].foreign.end(),
                                  [&](std::uint32_t grain) { return sleep.sleeps(grain); });
  }
  return rests;
}

}  // namespace diefill::engine
