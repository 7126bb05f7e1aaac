// Which steps another engine may compute at once, and what it shows of the powder at their end.
#include <algorithm>

#include "process/powder/time_steps.h"
#include "process/run/duty_steps.h"
#include "process/run/fill_run.h"

namespace diefill::process {

namespace {

/// Over the limit of pinched grains: overlaps that are worth a look (engine/limits/pinched_grains.h).
constexpr double kShallowPinch = 0.25;

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

/// Has another engine show what duties and probes ask for at the present step.
void FillRun::show_what_is_due() {
  const std::uint64_t step = simulation_->steps();
  const double time_step = simulation_->settings().time_step;
  const bool pinched = step % kPinchEvery == 0 && scene_.numerics.pinched_grains != PinchedGrains::stop &&
                       simulation_->overlaps().any_over_radius() > kShallowPinch * kShearingOverlap;
  if (pinched || step % kSpillEvery == 0 || probes_.looks_at_contacts(step, time_step))
    options_.engine->show_contacts(*simulation_);
  else if (step % kScheduleEvery == 0 || probes_.next_look(step - 1, time_step) == step ||
           (scene_.measure.snapshot_interval > 0 && step % steps_between_instants() == 0))
    options_.engine->show_grains(*simulation_);
}

void FillRun::show_contacts() {
  if (options_.engine != nullptr) options_.engine->show_contacts(*simulation_);
}

}  // namespace diefill::process
