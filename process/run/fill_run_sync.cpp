// Steps computed by another engine: at which steps grains and contacts are brought back into the simulation.
#include <algorithm>

#include "process/powder/time_steps.h"
#include "process/run/check_intervals.h"
#include "process/run/fill_run.h"

namespace diefill::process {

namespace {

/// Over the limit of pinched grains: from this overlap on a grain may exceed the limit soon.
constexpr double kDeepPinch = 0.5;

}  // namespace

void FillRun::make_step() {
  if (options_.engine == nullptr) return simulation_->step();
  options_.engine->step(*simulation_, next_sync_step());
  sync_if_due();
}

/// The next step at which a check, a probe or a stored instant needs the grains.
std::uint64_t FillRun::next_sync_step() const {
  const std::uint64_t step = simulation_->steps();
  const auto next = [step](std::uint64_t every) { return (step / every + 1) * every; };
  std::uint64_t sync_step =
      std::min(next(kPinchInterval), probes_.next_sync_step(step, simulation_->settings().time_step));
  if (scene_.measure.snapshot_interval > 0) sync_step = std::min(sync_step, next(steps_between_instants()));
  return sync_step;
}

/// Whether the grains are up to date at the present step.
bool FillRun::at_sync_step() const {
  return options_.engine == nullptr || simulation_->steps() % kPinchInterval == 0;
}

/// Updates what periodic tasks and probes need of the powder at the present step. Conditions of the schedule
/// see the powder as of the last update.
void FillRun::sync_if_due() {
  const std::uint64_t step = simulation_->steps();
  const double time_step = simulation_->settings().time_step;
  const bool pinched = step % kPinchInterval == 0 && scene_.numerics.pinched_grains != PinchedGrains::stop &&
                       simulation_->overlaps().any_over_radius() > kDeepPinch * kShearingOverlap;
  const bool feeds = step % kFeedInterval == 0 && source_.any();
  const bool instant = scene_.measure.snapshot_interval > 0 && step % steps_between_instants() == 0;
  if (pinched || feeds || step % kContactSyncInterval == 0 || probes_.needs_contacts(step, time_step))
    options_.engine->sync_contacts(*simulation_);
  else if (instant || step % kSpillInterval == 0 || probes_.next_sync_step(step - 1, time_step) == step)
    options_.engine->sync_grains(*simulation_);
}

void FillRun::sync_contacts() {
  if (options_.engine != nullptr) options_.engine->sync_contacts(*simulation_);
}

bool FillRun::contacts_are_synced() const {
  return options_.engine == nullptr || options_.engine->contacts_are_synced();
}

}  // namespace diefill::process
