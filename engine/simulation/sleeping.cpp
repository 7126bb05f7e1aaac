#include "engine/simulation/sleeping.h"

#include <algorithm>
#include <stdexcept>

namespace diefill::engine {

SleepSettings co_moving_with(std::size_t carrier) {
  SleepSettings settings;
  settings.energy = 0.05;  // a speed of 0.32 sqrt(g d)
  settings.time = 10e-3;
  settings.stray = 0.1;
  settings.force = 100;  // forces leap as the floor's bumps pass
  settings.speed = 3;
  settings.carrier = carrier;
  return settings;
}

void check(const SleepSettings& settings) {
  if (!(settings.energy > 0 && settings.time > 0 && settings.force > 0 && settings.speed > 0 &&
        settings.acceleration > 0 && settings.stray >= 0))
    throw std::invalid_argument("limits of sleeping grains must be positive");
}

std::size_t SleepState::sleepers() const {
  return static_cast<std::size_t>(std::count(asleep.begin(), asleep.end(), 1));
}

void SleepState::resize(std::size_t grains, const SleepSettings& settings) {
  asleep.resize(grains, 0);
  checks.resize(grains, 0);
  force.resize(grains, Eigen::Vector3d::Zero());
  if (settings.stray > 0) place.resize(grains, Eigen::Vector3d::Zero());
}

void SleepState::reorder(const std::vector<std::uint32_t>& order) {
  SleepState sorted;
  for (const std::uint32_t k : order) {
    sorted.asleep.push_back(asleep[k]);
    sorted.checks.push_back(checks[k]);
    sorted.force.push_back(force[k]);
    if (!place.empty()) sorted.place.push_back(place[k]);
  }
  sorted.sphere_steps_left_out = sphere_steps_left_out;
  *this = std::move(sorted);
}

void SleepState::put_to_sleep(const std::vector<std::uint32_t>& grains) {
  for (const std::uint32_t k : grains) {
    asleep[k] = 1;
    checks[k] = 0;
  }
}

void SleepState::wake(std::size_t grain) {
  asleep[grain] = 0;
  checks[grain] = 0;
}

void SleepState::wake_all() {
  std::fill(asleep.begin(), asleep.end(), std::uint8_t{0});
  std::fill(checks.begin(), checks.end(), 0U);
}

}  // namespace diefill::engine
