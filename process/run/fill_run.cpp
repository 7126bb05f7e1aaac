#include "process/run/fill_run.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/limits/pinched_grains.h"
#include "engine/numerics/seconds_since.h"
#include "engine/observe/powder_figures.h"
#include "process/input/units.h"
#include "process/powder/material.h"
#include "process/powder/mixed_powder.h"
#include "process/results/formatted.h"
#include "process/run/check_intervals.h"
#include "process/run/economies.h"
#include "process/run/powder_domain.h"
#include "process/run/suction.h"
#include "process/scene/setting.h"
#include "process/setup/impact_speed.h"
#include "process/setup/pour.h"
#include "process/tooling/co_moving_powder.h"
#include "process/tooling/die_frame.h"
#include "process/tooling/half_model.h"
#include "process/tooling/tool_paths.h"
#include "process/tooling/wall_bodies.h"

namespace diefill::process {

namespace {

using Clock = std::chrono::steady_clock;

/// Grains that may be sheared off however few there are.
constexpr double kFewSheared = 3;

}  // namespace

FillRun::FillRun(const Scene& scene, const Tooling& tooling, const RunOptions& options)
    : scene_(scene),
      tooling_(tooling),
      options_(options),
      grain_diameter_(scene.powder.grain_diameter),
      schedule_(scene, tooling, grain_diameter_),
      source_(scene, tooling),
      probes_(scene, tooling),
      free_tools_(scene, tooling),
      snapshots_(scene),
      lost_grains_(tooling, grain_diameters(scene)),
      leak_watch_(tooling, largest_grain(scene)),
      stray_watch_(tooling),
      progress_(options.show_progress) {
  const auto grains = pour(scene, engine_settings(scene, 1.0), tooling);
  if (setting_of(scene)) throw std::logic_error("a setting must be turned into numbers before a scene runs");
  const double impact = predicted_impact_speed(scene, tooling);
  auto settings = engine_settings(scene, impact);
  settings.threads = options.threads;
  settings.air_flow = air_flow_of(scene, tooling, settings);
  if (auto carried = co_moving_powder(scene, tooling)) settings.sleep = std::move(carried);
  critical_step_ = process::critical_time_step(settings, impact);
  simulation_ = std::make_unique<engine::Simulation>(settings, wall_bodies(scene, tooling));

  domain_ = powder_domain(scene, tooling, schedule_);
  const double largest = largest_grain(scene);
  const double width = tooling.all_cavities().narrowest_width;
  if (tooling.cavity.found && width > 0 && largest > width / 3) {
    warnings_.push_back(results::formatted(
        "grain diameter over cavity width is %.2f, above 1/3 (%.2f mm in %.2f mm): too coarse for a reliable "
        "density map, use it only for a first look, or grains of %.3g mm or less (powder.grain_diameter)",
        largest / width, 1e3 * largest, 1e3 * width, 1e3 * width / 3));
  }
  started_ = last_checkpoint_ = Clock::now();
  schedule_.begin(*simulation_);
  simulation_->add_grains(grains);
  change_powder();
  probes_.begin(*simulation_);
  simulation_->watch_borders(
      [this](std::size_t k, const Eigen::Vector3d& before, const Eigen::Vector3d& now) {
        probes_.count_wrapped(before, now, simulation_->shape_of(k).mass);
      });
  hash_inputs();
}

void FillRun::run() {
  start_or_resume();
  ForcedToolWatch forced_tools(scene_, tooling_);
  while (!schedule_.finished() && !(at_sync_step() && (out_of_time() || cannot_end()))) {
    free_tools_.before_step(*simulation_);
    make_step();
    free_tools_.after_step(*simulation_);
    sphere_steps_ += engine::sphere_count(*simulation_);
    schedule_.observe(*simulation_);
    probes_.observe(*simulation_);
    if (simulation_->steps() % kForcedToolInterval == 0) forced_tools.check(*simulation_);
    do_periodic_tasks();
  }
  sync_contacts();
  // The run may go on from here, where an unbroken one would not yet look: what the checks find is not in the
  // checkpoint.
  engine::ValidityMonitor at_end = monitor_;
  at_end.check(*simulation_);
  if (!schedule_.finished()) write_checkpoint();
  monitor_ = std::move(at_end);
  check_for_lost_grains();
  // Kept until the results stand: measuring and drawing can then be tried again without simulating.
  if (schedule_.finished()) write_checkpoint();
}

void FillRun::do_periodic_tasks() {
  const std::uint64_t step = simulation_->steps();
  if (step % kPinchInterval == 0 && contacts_are_synced()) shear_off_pinched_grains();
  if (step % kValidityInterval == 0 && contacts_are_synced()) monitor_.check(*simulation_);
  if (step % kLostGrainInterval == 0) check_for_lost_grains();
  if (step % kSpillInterval == 0) remove_spilled_grains();
  if (scene_.measure.snapshot_interval > 0) keep_instant();
  bool stage_over = false;
  // Before the schedule forgets the loads it has summed.
  if (step % kScheduleInterval == 0) take_snapshots();
  if (step % kScheduleInterval == 0) stage_over = schedule_.update(*simulation_);
  if (step % kScheduleInterval == 0) free_tools_.follow(schedule_, *simulation_);
  if (stage_over) sync_contacts();
  if (stage_over) clear_powder();
  if (stage_over) change_powder();
  if (step % kFeedInterval == 0 && source_.any()) feed_powder();
  if (step % kScheduleInterval == 0) look_for_standstill();
  if (stage_over) {
    progress_.note("t = " + std::to_string(simulation_->time()) + " s: " + schedule_.description());
    check_for_lost_grains();
  }
  if (step % kScheduleInterval == 0) show_progress();
  if (!at_sync_step()) return;
  if (options_.stop != nullptr && options_.stop->load()) stop_with_checkpoint();
  // Of another engine only where its contacts are read anyway: conditions of the schedule see the powder as
  // last read, and must not see it earlier because a clock ran out.
  const bool due = engine::seconds_since(last_checkpoint_) > scene_.numerics.checkpoint_interval;
  if (stage_over || (due && contacts_are_synced())) write_checkpoint();
  if (stage_over && !schedule_.finished()) save_shared_start();
}

std::vector<results::ProbeSeries> FillRun::probes() const {
  auto all = probes_.series();
  for (auto& motion : free_tools_.recorded_motions()) all.push_back(std::move(motion));
  return all;
}

void FillRun::remove_spilled_grains() {
  const auto& places = simulation_->grains().position;
  if (std::all_of(places.begin(), places.end(), [&](const auto& place) { return domain_.contains(place); }))
    return;
  sync_contacts();
  const DieFrame die = die_frame(*simulation_, tooling_);
  remove_grains([&](const Eigen::Vector3d& position) {
    const bool leaves = !domain_.contains(position);
    if (leaves) leak_watch_.count_removed(die.point(position));
    return leaves;
  });
  if (const auto first_warning = leak_watch_.first_warning(grains_poured()))
    progress_.note("warning: by t = " + std::to_string(simulation_->time()) + " s, " + *first_warning);
}

void FillRun::take_snapshots() {
  for (const std::string& name : snapshots_.due(schedule_, *simulation_)) {
    sync_contacts();
    if (options_.snapshot) options_.snapshot(*this, name);
  }
}

void FillRun::shear_off_pinched_grains() {
  if (scene_.numerics.pinched_grains == PinchedGrains::stop) return;
  std::vector<std::uint64_t> ids;
  for (const auto& grain : engine::pinched_grains(*simulation_, kShearingOverlap)) ids.push_back(grain.id);
  if (ids.empty()) return;
  const auto poured = static_cast<double>(grains_poured());
  for (const std::uint64_t id : ids) {
    const std::size_t k = place_of(id);
    count_out(k);
    sheared_.add(simulation_->grains().type_of(k));
  }
  simulation_->remove_grains(ids);
  const double most = scene_.numerics.most_sheared;
  if (static_cast<double>(sheared_.grains()) > std::max(kFewSheared, most * poured))
    throw engine::OutOfRange(shear_warning() + " by t = " + std::to_string(simulation_->time()) +
                             " s, more than " + number_text(100 * most) +
                             " % of all (numerics.most_sheared): use smaller model grains or a shorter time "
                             "step, chamfer the edges that move past each other, or raise the limit");
}

std::string FillRun::shear_warning() const {
  const double sheared = copies(tooling_) * static_cast<double>(sheared_.grains());
  char text[240];
  std::snprintf(
      text, sizeof text,
      "%llu grains (%.3g g) were wedged between tools moving past each other and were removed (sheared off)",
      static_cast<unsigned long long>(sheared), 1e3 * copies(tooling_) * sheared_.mass(simulation_->types()));
  return text;
}

/// Counted in steps, so that a restart keeps the same instants.
std::uint64_t FillRun::steps_between_instants() const {
  const double interval = scene_.measure.snapshot_interval / simulation_->settings().time_step;
  return static_cast<std::uint64_t>(std::max(1.0, std::round(interval)));
}

void FillRun::keep_instant() {
  if (simulation_->steps() % steps_between_instants() != 0) return;
  const auto& grains = simulation_->grains();
  results::Instant instant;
  instant.time = simulation_->time();
  instant.id = grains.id;
  if (!simulation_->types().monodisperse()) instant.kind.assign(grains.kind.begin(), grains.kind.end());
  instant.position = grains.position;
  instant.orientation = grains.orientations();
  instant.velocity = grains.velocity;
  for (std::size_t b = 0; b < tooling_.tools.size(); ++b) {
    const auto& motion = simulation_->body_motion(b);
    const Eigen::Quaterniond turn(motion.rotation);
    instant.tool_orientation.emplace_back(turn.w(), turn.x(), turn.y(), turn.z());
    instant.tool_displacement.push_back(motion.translation);
  }
  instants_.push_back(std::move(instant));
}

void FillRun::check_for_lost_grains() {
  const auto strayed = lost_grains_.strayed(
      *simulation_, static_cast<double>(kLostGrainInterval) * simulation_->settings().time_step);
  if (strayed.empty()) return;
  sync_contacts();
  const bool first = stray_watch_.state().grains == 0;
  std::vector<std::uint64_t> ids;
  for (const StrayGrain& grain : strayed) {
    const std::size_t k = place_of(grain.id);
    count_out(k);
    removed_.add(simulation_->grains().type_of(k));
    stray_watch_.count_removed(grain, simulation_->time());
    ids.push_back(grain.id);
  }
  simulation_->remove_grains(ids);
  if (first) progress_.note("warning: " + *stray_watch_.warning(grains_poured()));
}

std::size_t FillRun::place_of(std::uint64_t id) const {
  const auto& ids = simulation_->grains().id;
  return static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
}

void FillRun::show_progress() {
  const double now = simulation_->time();
  char rate[96], doing[160];
  std::snprintf(rate, sizeof rate, "%.2f million sphere-steps/s",
                1e-6 * static_cast<double>(sphere_steps_) / wall_seconds());
  std::snprintf(doing, sizeof doing, "t = %.4f s, %s", now, schedule_.description().c_str());
  progress_.show(share_done(), doing, rate);
  if (options_.watch) options_.watch(*this);
}

double FillRun::share_done() const {
  const double now = simulation_->time(), left = schedule_.time_left(now, kSettlingGuess);
  return now + left > 0 ? now / (now + left) : 0;
}

double FillRun::wall_seconds() const {
  return earlier_wall_seconds_ + engine::seconds_since(started_);
}

std::vector<std::string> FillRun::warnings() const {
  std::vector<std::string> all = warnings_;
  if (options_.engine != nullptr) all.push_back(options_.engine->description());
  if (ended_early())
    all.insert(all.begin(), "unfinished: " + why_unfinished() + "; all figures refer to this time");
  for (auto& economy : economies_text(scene_, *simulation_, sphere_steps_)) all.push_back(std::move(economy));
  for (auto& overlap : engine::overlap_warnings(*simulation_)) all.push_back(std::move(overlap));
  all.insert(all.end(), monitor_.warnings().begin(), monitor_.warnings().end());
  if (sheared_.grains() > 0) all.push_back(shear_warning());
  if (auto leak = leak_watch_.warning(grains_poured())) all.push_back(std::move(*leak));
  if (auto stray = stray_watch_.warning(grains_poured())) all.push_back(std::move(*stray));
  return all;
}

}  // namespace diefill::process
