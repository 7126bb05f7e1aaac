#include "process/run/fill_run.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/limits/pinched_grains.h"
#include "process/input/units.h"
#include "process/machine/actions/clear.h"
#include "process/measure/cavity_position.h"
#include "process/powder/changed_scene.h"
#include "process/powder/material.h"
#include "process/powder/mixed_powder.h"
#include "process/powder/random.h"
#include "process/run/duty_steps.h"
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

double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

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
    char text[240];
    std::snprintf(text, sizeof text,
                  "grain diameter over cavity width is %.2f, above 1/3 (%.2f mm in %.2f mm): too coarse for "
                  "a reliable density map, use it only for a first look",
                  largest / width, 1e3 * largest, 1e3 * width);
    warnings_.emplace_back(text);
  }
  started_ = last_checkpoint_ = Clock::now();
  schedule_.begin(*simulation_);
  simulation_->add_grains(grains);
  change_powder();
  probes_.begin(*simulation_);
}

void FillRun::run() {
  start_or_resume();
  ForcedToolWatch forced_tools(scene_, tooling_);
  while (!schedule_.finished() && !(at_look() && out_of_time())) {
    free_tools_.before_step(*simulation_);
    make_step();
    free_tools_.after_step(*simulation_);
    sphere_steps_ += simulation_->grains().size() * simulation_->types().spheres();
    schedule_.observe(*simulation_);
    probes_.observe(*simulation_);
    if (simulation_->steps() % kForcedEvery == 0) forced_tools.look(*simulation_);
    duties();
  }
  show_contacts();
  monitor_.check(*simulation_);
  // The run may go on from here, where an unbroken one would not yet look.
  if (!schedule_.finished()) write_checkpoint();
  look_for_lost_grains();
  // Kept until the results stand: measuring and drawing can then be tried again without simulating.
  if (schedule_.finished()) write_checkpoint();
}

void FillRun::duties() {
  const std::uint64_t step = simulation_->steps();
  if (step % kPinchEvery == 0 && contacts_are_shown()) shear_off_pinched_grains();
  if (step % kValidityCheckEvery == 0 && contacts_are_shown()) monitor_.check(*simulation_);
  if (step % kLostEvery == 0) look_for_lost_grains();
  if (step % kSpillEvery == 0) let_spilled_grains_go();
  if (scene_.measure.snapshot_interval > 0) keep_instant();
  bool stage_over = false;
  // Before the schedule forgets the loads it has summed.
  if (step % kScheduleEvery == 0) take_snapshots();
  if (step % kScheduleEvery == 0) stage_over = schedule_.update(*simulation_);
  if (step % kScheduleEvery == 0) free_tools_.follow(schedule_, *simulation_);
  if (stage_over) show_contacts();
  if (stage_over) clear_powder();
  if (stage_over) change_powder();
  if (step % kFeedEvery == 0 && source_.any()) let_powder_in();
  if (stage_over) {
    progress_.say("t = " + std::to_string(simulation_->time()) + " s: " + schedule_.description());
    look_for_lost_grains();
  }
  if (step % kScheduleEvery == 0) show_progress();
  if (!at_look()) return;
  if (options_.stop != nullptr && options_.stop->load()) stop_with_checkpoint();
  if (stage_over || seconds_since(last_checkpoint_) > scene_.numerics.checkpoint_interval) write_checkpoint();
  if (stage_over && !schedule_.finished()) save_shared_start();
}

std::vector<results::ProbeSeries> FillRun::probes() const {
  auto all = probes_.series();
  for (auto& motion : free_tools_.recorded_motions()) all.push_back(std::move(motion));
  return all;
}

void FillRun::let_spilled_grains_go() {
  const auto& places = simulation_->grains().position;
  if (std::all_of(places.begin(), places.end(), [&](const auto& place) { return domain_.contains(place); }))
    return;
  show_contacts();
  const DieFrame die(simulation_->body_motion(tooling_.die));
  remove_grains([&](const Eigen::Vector3d& position) {
    const bool leaves = !domain_.contains(position);
    if (leaves) leak_watch_.has_left(die.point(position));
    return leaves;
  });
  if (const auto news = leak_watch_.news(grains_poured()))
    progress_.say("warning: by t = " + std::to_string(simulation_->time()) + " s, " + *news);
}

std::uint64_t FillRun::grains_poured() const {
  return simulation_->grains().size() + left_.grains() + sheared_.grains();
}

void FillRun::remove_grains(const std::function<bool(const Eigen::Vector3d&)>& leaves) {
  const engine::Grains& grains = simulation_->grains();
  std::size_t k = 0;
  simulation_->remove_grains([&](const Eigen::Vector3d& position) {
    const engine::TypeNumber kind = grains.type_of(k++);
    const bool gone = leaves(position);
    if (gone) probes_.count_removed(position, simulation_->types().shape(kind).mass, 1);
    if (gone) left_.add(kind);
    return gone;
  });
}

void FillRun::let_powder_in() {
  // Ids count all grains that ever were.
  const std::uint64_t before = grains_poured();
  source_.feed(*simulation_, schedule_);
  const auto& grains = simulation_->grains();
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (grains.id[k] >= before) probes_.count_removed(grains.position[k], simulation_->shape_of(k).mass, -1);
}

void FillRun::clear_powder() {
  for (std::size_t k = 0; k < scene_.steps.size(); ++k) {
    const PowderRemoval* removal = scene_.steps[k]->removal();
    if (removal == nullptr || schedule_.of_step(k).started != simulation_->time()) continue;
    std::vector<results::CavityState> cavities = {cavity_state(tooling_.cavity)};
    for (const auto& other : tooling_.other_cavities) cavities.push_back(cavity_state(other));
    for (auto& cavity : cavities) cavity.upper_corner[2] += removal->heap;
    const DieFrame die(simulation_->body_motion(tooling_.die));
    remove_grains([&](const Eigen::Vector3d& place) {
      return std::none_of(cavities.begin(), cavities.end(), [&](const results::CavityState& cavity) {
        return lies_in_cavity(cavity, die.point(place));
      });
    });
  }
}

void FillRun::change_powder() {
  for (std::size_t k = 0; k < scene_.steps.size(); ++k) {
    const PowderChange* change = scene_.steps[k]->change();
    if (change == nullptr || schedule_.of_step(k).started != simulation_->time()) continue;
    put_changed_laws();
    if (change->random_velocity > 0) add_random_velocities(change->random_velocity, k);
  }
}

/// Gravity and contact laws as the steps that have begun leave them.
void FillRun::put_changed_laws() {
  Scene now = scene_;
  bool changed = false, laws = false;
  for (std::size_t k = 0; k < scene_.steps.size(); ++k) {
    const PowderChange* change = scene_.steps[k]->change();
    if (change == nullptr || schedule_.of_step(k).waits()) continue;
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

void FillRun::take_snapshots() {
  for (const std::string& name : snapshots_.due(schedule_, *simulation_)) {
    show_contacts();
    if (options_.snapshot) options_.snapshot(*this, name);
  }
}

void FillRun::shear_off_pinched_grains() {
  if (scene_.numerics.pinched_grains == PinchedGrains::stop) return;
  std::vector<std::uint64_t> ids;
  for (const auto& grain : engine::pinched_grains(*simulation_, kShearingOverlap)) ids.push_back(grain.id);
  if (ids.empty()) return;
  const auto poured = static_cast<double>(grains_poured());
  for (const std::uint64_t id : ids) sheared_.add(simulation_->grains().type_of(place_of(id)));
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

void FillRun::look_for_lost_grains() {
  auto strayed =
      lost_grains_.strayed(*simulation_, static_cast<double>(kLostEvery) * simulation_->settings().time_step);
  if (strayed.empty()) return;
  show_contacts();
  // Where tools touch, a grain may have come into two.
  std::sort(strayed.begin(), strayed.end());
  strayed.erase(std::unique(strayed.begin(), strayed.end()), strayed.end());
  for (const std::uint64_t id : strayed) {
    const std::size_t k = place_of(id);
    probes_.count_removed(simulation_->grains().position[k], simulation_->shape_of(k).mass, 1);
    left_.add(simulation_->grains().type_of(k));
  }
  simulation_->remove_grains(strayed);
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
  return earlier_wall_seconds_ + seconds_since(started_);
}

std::vector<std::string> FillRun::warnings() const {
  std::vector<std::string> all = warnings_;
  if (options_.engine != nullptr) all.push_back(options_.engine->description());
  if (ran_out_of_time())
    all.insert(all.begin(), "unfinished: " + why_unfinished() + "; all figures refer to this time");
  for (auto& economy : economies_text(scene_, *simulation_, sphere_steps_)) all.push_back(std::move(economy));
  all.insert(all.end(), monitor_.warnings().begin(), monitor_.warnings().end());
  if (sheared_.grains() > 0) all.push_back(shear_warning());
  if (auto leak = leak_watch_.warning(grains_poured())) all.push_back(std::move(*leak));
  return all;
}

}  // namespace diefill::process
