// What a run adds to its powder, takes away from it and changes about it as the steps of the schedule begin.
#include <algorithm>

#include "process/machine/actions/clear.h"
#include "process/machine/actions/powder_change.h"
#include "process/measure/cavity_position.h"
#include "process/powder/changed_scene.h"
#include "process/powder/material.h"
#include "process/powder/random.h"
#include "process/run/fill_run.h"
#include "process/tooling/die_frame.h"

namespace diefill::process {

std::uint64_t FillRun::grains_poured() const {
  return simulation_->grains().size() + removed_.grains() + sheared_.grains();
}

void FillRun::remove_grains(const std::function<bool(const Eigen::Vector3d&)>& leaves) {
  const engine::Grains& grains = simulation_->grains();
  std::size_t k = 0;
  simulation_->remove_grains([&](const Eigen::Vector3d& position) {
    const engine::TypeNumber kind = grains.type_of(k++);
    const bool gone = leaves(position);
    if (gone) probes_.count_removed(position, simulation_->types().shape(kind).mass, 1);
    if (gone) removed_.add(kind);
    return gone;
  });
}

/// For the probes: grain k is about to be taken out, from its place in the periodic box.
void FillRun::count_out(std::size_t k) {
  const Eigen::Vector3d place = simulation_->state().box.wrapped(simulation_->grains().position[k]);
  probes_.count_removed(place, simulation_->shape_of(k).mass, 1);
}

void FillRun::feed_powder() {
  // Ids count all grains that ever were.
  const std::uint64_t before = grains_poured();
  if (source_.feed(*simulation_, schedule_) > 0) standstill_.since = -1;
  const auto& grains = simulation_->grains();
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (grains.id[k] >= before) probes_.count_removed(grains.position[k], simulation_->shape_of(k).mass, -1);
}

void FillRun::clear_powder() {
  for (std::size_t k = 0; k < scene_.steps.size(); ++k) {
    const PowderRemoval* removal = scene_.steps[k]->removal();
    if (removal == nullptr || schedule_.of_step(k).started != simulation_->time()) continue;
    const auto above = removal->lowest ? height_of_lowest(*removal->lowest) : removal->above;
    if (above)
      remove_grains([&](const Eigen::Vector3d& place) { return place.z() > *above; });
    else
      clear_outside_cavities(removal->heap);
  }
}

/// m, of the centre of the highest of the lowest `share` of all grains.
std::optional<double> FillRun::height_of_lowest(double share) const {
  std::vector<double> heights;
  for (const auto& place : simulation_->grains().position) heights.push_back(place.z());
  const auto kept = static_cast<std::ptrdiff_t>(share * static_cast<double>(heights.size()));
  if (heights.empty()) return {};
  const auto last = heights.begin() + std::max<std::ptrdiff_t>(kept - 1, 0);
  std::nth_element(heights.begin(), last, heights.end());
  return *last;
}

void FillRun::clear_outside_cavities(double heap) {
  std::vector<results::CavityState> cavities = cavity_states(tooling_);
  for (auto& cavity : cavities) cavity.upper_corner[2] += heap;
  const DieFrame die = die_frame(*simulation_, tooling_);
  remove_grains(
      [&](const Eigen::Vector3d& place) { return !lies_in_any_cavity(cavities, die.point(place)); });
}

void FillRun::change_powder() {
  for (std::size_t k = 0; k < scene_.steps.size(); ++k) {
    const PowderChange* change = scene_.steps[k]->change();
    if (change == nullptr || schedule_.of_step(k).started != simulation_->time()) continue;
    apply_changed_laws();
    if (change->at_rest) simulation_->stop_grains();
    if (change->random_velocity > 0) add_random_velocities(change->random_velocity, k);
  }
}

/// Gravity and contact laws as the steps that have begun leave them.
void FillRun::apply_changed_laws() {
  Scene now = scene_;
  bool changed = false, laws = false;
  for (std::size_t k = 0; k < scene_.steps.size(); ++k) {
    const PowderChange* change = scene_.steps[k]->change();
    if (change == nullptr || schedule_.of_step(k).is_pending()) continue;
    now = changed_scene(std::move(now), *change);
    changed = true;
    laws = laws || change->changes_laws();
  }
  if (!changed) return;
  simulation_->set_gravity(now.gravity);
  if (laws) simulation_->set_contact(contact_laws(now, simulation_->settings().time_step));
}

void FillRun::add_random_velocities(double deviation, std::size_t step) {
  // Each grain has its own numbers, whatever the order in memory.
  const std::uint64_t seed = scene_.seed + (static_cast<std::uint64_t>(step) << 32U);
  simulation_->add_velocities(
      [&](std::uint64_t id) -> Eigen::Vector3d { return deviation * Random(seed, id).normal_vector(); });
}

}  // namespace diefill::process
