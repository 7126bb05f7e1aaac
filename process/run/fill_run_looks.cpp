// Which steps another engine may compute at once, and what it shows of the powder at their end.
#include <algorithm>

#include "process/powder/time_steps.h"
#include "process/run/duty_steps.h"
#include "process/run/fill_run.h"

namespace diefill::process {

namespace {

/// Over the limit of pinched grains: an overlap from which on one may be beyond it soon.
constexpr double kDeepPinch = 0.5;

}  // namespace

void FillRun::make_step() {
  if (options_.engine == nullptr) return simulation_->step();
  options_.engine->step(*simulation_, next_look());
  show_what_is_due();
}

/// The first step to come at which anybody may ask for the powder.
std::uint64_t FillRun::next_look() const {
  const std::uint64_t step = simulation_->steps();
  const auto next = [step](std::uint64_t every) { return (step / every + 1) * every; };
  std::uint64_t look =
      std::min(next(kPinchEvery), probes_.next_look(step, simulation_->settings().time_step));
  if (scene_.measure.snapshot_interval > 0) look = std::min(look, next(steps_between_instants()));
  return look;
}

/// Whether the powder can be asked for at the present step.
bool FillRun::at_look() const {
  return options_.engine == nullptr || simulation_->steps() % kPinchEvery == 0;
}

/// Has another engine show what duties and probes ask for at the present step. Conditions of the schedule see
/// the powder as it was last shown.
void FillRun::show_what_is_due() {
  const std::uint64_t step = simulation_->steps();
  const double time_step = simulation_->settings().time_step;
  const bool pinched = step % kPinchEvery == 0 && scene_.numerics.pinched_grains != PinchedGrains::stop &&
                       simulation_->overlaps().any_over_radius() > kDeepPinch * kShearingOverlap;
  const bool feeds = step % kFeedEvery == 0 && source_.any();
  const bool instant = scene_.measure.snapshot_interval > 0 && step % steps_between_instants() == 0;
  if (pinched || feeds || step % kContactsEvery == 0 || probes_.looks_at_contacts(step, time_step))
    options_.engine->show_contacts(*simulation_);
  else if (instant || step % kSpillEvery == 0 || probes_.next_look(step - 1, time_step) == step)
    options_.engine->show_grains(*simulation_);
}

void FillRun::show_contacts() {
  if (options_.engine != nullptr) options_.engine->show_contacts(*simulation_);
}

bool FillRun::contacts_are_shown() const {
  return options_.engine == nullptr || options_.engine->contacts_are_shown();
}

}  // namespace diefill::process
