#include "engine/simulation/simulation.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "engine/numerics/prefetch.h"
#include "engine/powder/rigid_motion.h"
#include "engine/search/spatial_order.h"
#include "engine/simulation/simulation_parts.h"

namespace diefill::engine {

namespace {

/// Sums of a block's pairs that a thread works on: all 0 between blocks.
std::vector<ContactSum>& pair_sums_of_thread() {
  thread_local std::vector<ContactSum> sums;
  return sums;
}

/// From so many blocks on, what a block is finished from has left the caches by the time that the pairs of
/// all have been computed. With fewer, threads would wait for each other in the end for nothing.
constexpr std::size_t kManyBlocks = 64;

}  // namespace

Simulation::Simulation(const SimulationSettings& settings, std::vector<WallBodySpec> walls)
    : types_(moving_types(settings.types, settings.contact.scaling)),
      settings_(checked(settings, types_)),
      pool_(settings_.threads),
      box_(settings_.period),
      grain_loop_(grain_loop_for(settings_, types_)),
      wall_loop_(wall_loop_for(settings_, types_, walls)),
      list_(neighbour_settings(types_, *grain_loop_, *wall_loop_), first_sphere_of_bodies(walls)),
      skin_(skin_for(settings_, types_, grain_loop_->range())),
      integrator_(types_, settings_.gravity, settings_.air_viscosity,
                  grain_loop_->rolls() || wall_loop_->rolls(), settings_.time_step, settings_.instructions) {
  for (auto& wall : walls) {
    const double reach = types_.largest_sphere() + wall.sphere_radius + 2 * skin_.largest_allowance() +
                         (wall.mirror ? grain_loop_->range() : 0);
    bodies_.emplace_back(std::move(wall), reach);
    body_motion_.push_back(bodies_.back().motion_at(0));
  }
  wall_loads_.resize(bodies_.size());
  clearance_.resize(bodies_.size());
  if (settings_.sleep) sleeping_.emplace(*settings_.sleep, types_, settings_.gravity, settings_.time_step);
  spheres_.spheres_per_grain = types_.spheres();
  spheres_.box = box_;
  number_spheres_of_types(types_, spheres_);
  reference_.skin = skin_.first();
  sort_and_search();
}

void Simulation::add_grains(const std::vector<NewGrain>& added) {
  for (const auto& grain : added)
    if (grain.kind >= types_.size())
      throw std::invalid_argument("a grain of kind " + std::to_string(grain.kind) + ", but there are " +
                                  std::to_string(types_.size()) + " kinds, counted from 0");
  // Contacts are between spheres where they are now, so that their energy must be known before grains are
  // put back into the periodic box, whose own booking is in the difference.
  const double before = energy().total(), added_before = ledger_.added_energy;
  wrap_grains();
  const std::size_t old_count = grains_.size();
  grains_.resize(old_count + added.size(), types_.clumps(), !types_.monodisperse());
  for (std::size_t k = 0; k < added.size(); ++k) {
    const std::size_t g = old_count + k;
    const NewGrain& grain = added[k];
    grains_.id[g] = next_id_++;
    if (!types_.monodisperse()) grains_.kind[g] = grain.kind;
    grains_.position[g] = box_.wrapped(grain.position);
    grains_.velocity[g] = grain.velocity;
    if (types_.clumps()) grains_.orientation[g] = grain.orientation.normalized();
    grains_.spin[g].setZero();
    if (types_.turns(grain.kind) || !types_.rotates())
      grains_.spin[g] = rotation_matrix(grains_.orientation_of(g)).transpose() * grain.angular_velocity;
    grains_.force[g] = shape_of(g).mass * settings_.gravity;
    grains_.torque[g].setZero();
  }
  sort_and_search();
  ledger_.added_energy = added_before + (energy().total() - before);
}

std::size_t Simulation::remove_grains(const std::function<bool(const Eigen::Vector3d&)>& leaves) {
  std::vector<std::uint32_t> staying;
  for (std::uint32_t k = 0; k < grains_.size(); ++k)
    if (!leaves(box_.wrapped(grains_.position[k]))) staying.push_back(k);
  return keep_grains(staying);
}

std::size_t Simulation::remove_grains(const std::vector<std::uint64_t>& ids) {
  std::vector<std::uint32_t> staying;
  for (std::uint32_t k = 0; k < grains_.size(); ++k)
    if (std::find(ids.begin(), ids.end(), grains_.id[k]) == ids.end()) staying.push_back(k);
  return keep_grains(staying);
}

std::size_t Simulation::keep_grains(const std::vector<std::uint32_t>& staying) {
  const std::size_t gone = grains_.size() - staying.size();
  if (gone == 0) return 0;
  const double before = energy().total(), added_before = ledger_.added_energy;
  wrap_grains();
  search_in_order(staying);
  ledger_.added_energy = added_before + (energy().total() - before);
  return gone;
}

void Simulation::set_motion(std::size_t body, std::function<BodyMotion(double)> motion) {
  bodies_.at(body).set_motion(std::move(motion));
  body_motion_[body] = bodies_[body].motion_at(time_);
}

Eigen::Vector3d Simulation::angular_velocity(std::size_t k) const {
  return rotation_matrix(grains_.orientation_of(k)) * grains_.spin[k];
}

void Simulation::step() {
  timers_.begin();
  ++step_;
  time_ = static_cast<double>(step_) * settings_.time_step;
  const BodyMotion carrier_before = carrier();
  move_bodies();
  if (sleeping_) mind_tools(carrier_before);
  advance_grains();
  timers_.lap(Phase::advance);
  if (list_is_old()) {
    reference_.skin = skin_.next(reference_.skin, step_ - reference_.step);
    if (carries()) fall_asleep();
    sort_and_search();
    timers_.lap(Phase::search);
  }
  if (sleeping_ || list_.blocks().size() < kManyBlocks) {
    compute_contacts();
    timers_.lap(Phase::contacts);
    finish_grains();
  } else {
    compute_and_finish();
  }
  book_step();
  if (sleeping_) look_after_sleepers();
  timers_.lap(Phase::gather);
}

void Simulation::move_bodies() {
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (bodies_[b].moves()) body_motion_[b] = bodies_[b].motion_at(time_);
}

void Simulation::advance_grains() {
  auto& blocks = list_.blocks();
  const Vector3 drifted = plain(Eigen::Vector3d(reference_.drift * settings_.time_step));
  pool_.for_each(blocks.size(), [&](std::size_t b) {
    // Ways of many steps are summed up, and places rounded: a little more than both together.
    constexpr double kRounding = 1 + 1e-6;
    if (sleeping_) {
      advance_awake(b);
      remaining_skin_[b] = 0;
    } else {
      remaining_skin_[b] -=
          kRounding * integrator_.advance(grains_, blocks[b].begin, blocks[b].end, drifted, spheres_);
    }
    if (remaining_skin_[b] <= 0) remaining_skin_[b] = remaining_skin(blocks[b]);
    tallies_[b].list_is_old = remaining_skin_[b] < 0;
  });
}

/// m, how much farther against the powder as a whole every sphere of the block may surely move before the
/// list is too old: below 0 when one has moved too far already.
double Simulation::remaining_skin(const Block& block) const {
  const Vector3 drifted = plain(Eigen::Vector3d(reference_.drift * (time_ - reference_.time)));
  const auto way = [&](std::size_t k) {
    prefetch<1>(k, reference_.position);
    return plain(grains_.position[k]) - plain(reference_.position[k]) - drifted;
  };
  double least = std::numeric_limits<double>::infinity();
  if (!types_.clumps()) {
    std::array<double, AdaptiveSkin::kMostDoublings + 1> farthest{};  // m^2, of those that may go as far
    for (std::size_t k = block.begin; k < block.end; ++k) {
      const Vector3 moved = way(k);
      double& squared = farthest[reference_.doublings[k]];
      squared = std::max(squared, dot(moved, moved));
    }
    for (std::size_t doublings = 0; doublings < farthest.size(); ++doublings)
      least = std::min(least, reference_.allowance_of(doublings) - std::sqrt(farthest[doublings]));
    return least;
  }
  const double way_per_turn = types_.way_per_turn();
  for (std::size_t k = block.begin; k < block.end; ++k) {
    const PlainQuaternion turn = plain(grains_.orientation[k]) - plain(reference_.orientation[k]);
    least =
        std::min(least, reference_.allowance(k) - length(way(k)) - way_per_turn * std::sqrt(dot(turn, turn)));
  }
  return least;
}

/// Turns `contacts`, the sums of the pairs of block b, into contact forces on its grains, moments about their
/// centres: adds those of other blocks' pairs, in block order. `contacts` may be the block's own.
void Simulation::gather(std::size_t b, ContactSums& contacts) const {
  const Block& own = list_.blocks()[b];
  const bool clumps = types_.clumps();
  // Sums of a resting block are those of where its grains were when contacts were searched.
  const auto places = [&](std::size_t block) -> const std::vector<Eigen::Vector3d>& {
    return rests(block) ? reference_.position : grains_.position;
  };
  if (clumps)
    for (std::size_t k = 0; k < own.grains(); ++k) {
      const Vector3 arm = plain(places(b)[own.begin + k]) - plain(own.reference);
      contacts.add_moment(k, -cross(arm, contacts.force(k)));
    }
  constexpr std::uint32_t kAhead = 32;  // sums of other blocks lie anywhere: they are asked for in time
  const std::uint32_t end = list_.foreign_first()[b + 1];
  for (std::uint32_t f = list_.foreign_first()[b]; f < end; ++f) {
    if (f + kAhead < end) {
      const auto& soon = list_.foreign_sums()[f + kAhead];
      list_.blocks()[soon.block].sums.fetch(soon.slot);
      contacts.fetch(soon.grain);
    }
    const auto& place = list_.foreign_sums()[f];
    const Block& block = list_.blocks()[place.block];
    const Vector3 force = block.sums.force(place.slot);
    Vector3 moment = block.sums.moment(place.slot);
    if (clumps) {
      const std::uint32_t seen = block.seen[place.slot - block.grains()];
      const Vector3 arm =
          plain(places(place.block)[own.begin + place.grain]) + spheres_.shift(seen) - plain(block.reference);
      moment = moment - cross(arm, force);
    }
    contacts.add_force(place.grain, force);
    contacts.add_moment(place.grain, moment);
    contacts.add_rolling_load(place.grain, block.sums.rolling_load(place.slot));
  }
}

void Simulation::compute_contacts() {
  pool_.for_each(list_.blocks().size(), [&](std::size_t b) {
    if (!rests(b))
      compute_block(b);
    else if (carries())
      slide(b);
  });
}

void Simulation::compute_block(std::size_t b) {
  Block& block = list_.blocks()[b];
  thread_local LocalSpheres local;
  local.take(block, spheres_, settings_.instructions);
  const ContactScene scene = contact_scene(local);
  tallies_[b].start(bodies_.size());
  std::vector<ContactSum>& sums = pair_sums_of_thread();
  if (sums.size() < block.sums.size()) sums.resize(block.sums.size());
  grain_loop_->add_forces(block, scene, sums, tallies_[b]);
  wall_loop_->add_forces(block, scene, sums, tallies_[b]);
  with_instructions(settings_.instructions, [&] { block.sums.keep(sums); });
}

void Simulation::finish_grains() {
  pool_.for_each(list_.blocks().size(), [&](std::size_t b) {
    if (!sleeping_)
      finish_block(b);
    else if (!rests(b))
      finish_awake(b, gathered_copy(b));
    else if (carries())
      tallies_[b].held_force = force_on_resting(b);
  });
}

/// Does what compute_contacts() and finish_grains() do where all are awake, but finishes a block as soon as
/// no other one needs its grains as they are.
void Simulation::compute_and_finish() {
  const std::size_t count = list_.blocks().size();
  if (awaited_.size() != count) awaited_ = std::vector<std::atomic<std::uint32_t>>(count);
  for (std::size_t b = 0; b < count; ++b) awaited_[b].store(list_.awaited_by(b), std::memory_order_relaxed);
  using Clock = std::chrono::steady_clock;
  pool_.for_each(count, [&](std::size_t b) {
    const auto began = Clock::now();
    compute_block(b);
    const auto computed = Clock::now();
    for (const std::uint32_t other : list_.waiting_for(b))
      if (awaited_[other].fetch_sub(1, std::memory_order_acq_rel) == 1) finish_block(other);
    tallies_[b].computing_time = std::chrono::duration<double>(computed - began).count();
    tallies_[b].finishing_time = std::chrono::duration<double>(Clock::now() - computed).count();
  });
  double computing = 0, finishing = 0;
  for (const auto& tally : tallies_) {
    computing += tally.computing_time;
    finishing += tally.finishing_time;
  }
  timers_.lap(Phase::contacts, Phase::gather, finishing / (computing + finishing));
}

void Simulation::finish_block(std::size_t b) {
  Block& block = list_.blocks()[b];
  // Nobody asks for the sums of the block's own pairs any more: they need not be copied.
  gather(b, block.sums);
  if (settings_.air_flow) draw_air(b, block.sums);
  const auto work = integrator_.finish(grains_, block.begin, block.end, block.sums, 0);
  tallies_[b].drag_work += work.drag;
  tallies_[b].rolling_work += work.rolling;
}

/// Adds the forces of drawn air to those of the contacts of block b.
void Simulation::draw_air(std::size_t b, ContactSums& contacts) {
  const AirFlow& air = *settings_.air_flow;
  const double speed = body_motion_[air.body].velocity.z();
  const Block& block = list_.blocks()[b];
  const double power = air.add_forces(spheres_, block.begin, block.end, speed, contacts);
  tallies_[b].drag_work += power * settings_.time_step;
}

void Simulation::book_step() {
  touching_ = 0;
  overlap_now_ = {};
  for (auto& load : wall_loads_) load = {};
  for (const auto& tally : tallies_) {
    ledger_.viscous_work += tally.viscous_work;
    ledger_.tangential_work += tally.tangential_work;
    ledger_.drag_work += tally.drag_work;
    ledger_.rolling_work += tally.rolling_work;
    touching_ += tally.touching;
    overlap_now_.include(tally.overlap);
    ledger_.sleep_work -= tally.held_force.dot(carried_);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      wall_loads_[b].force += tally.body_force[b];
      wall_loads_[b].torque += tally.body_torque[b];
    }
  }
  overlap_ever_.include(overlap_now_);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    ledger_.wall_work -= (wall_loads_[b].force.dot(body_motion_[b].velocity) +
                          wall_loads_[b].torque.dot(body_motion_[b].angular_velocity)) *
                         settings_.time_step;
}

ContactScene Simulation::contact_scene(const LocalSpheres& local) const {
  return {
      local, bodies_, body_motion_, types_.smallest_sphere(), settings_.time_step, settings_.instructions};
}

}  // namespace diefill::engine
