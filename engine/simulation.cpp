#include "engine/simulation.h"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "engine/rigid_motion.h"
#include "engine/spatial_order.h"

namespace diefill::engine {

namespace {

/// Default skin over sphere radius: wide enough for some tens of steps of falling powder, narrow enough that
/// the list stays short.
constexpr double kDefaultSkin = 0.5;

double farthest_sphere(const GrainShape& shape) {
  return shape.bounding_radius() - shape.sphere_radius;
}

LeverArm arm_for(const GrainShape& shape, LeverArm wanted) {
  if (!shape.rotates) return LeverArm::none;
  return shape.spheres() == 1 ? LeverArm::surface : wanted;
}

SimulationSettings checked(SimulationSettings settings) {
  if (settings.shape.sphere_offsets.empty()) throw std::invalid_argument("the grain shape has no spheres");
  if (!(settings.time_step > 0)) throw std::invalid_argument("the time step must be positive");
  if (settings.threads < 1) throw std::invalid_argument("at least one thread is needed");
  if (settings.skin <= 0) settings.skin = kDefaultSkin * settings.shape.sphere_radius;
  settings.lever_arm = arm_for(settings.shape, settings.lever_arm);
  const double smallest = 4 * settings.shape.bounding_radius() + 2 * settings.skin;
  for (const auto& period : settings.period)
    if (period && *period < smallest)
      throw std::invalid_argument("a periodic length is below two grain sizes and the skin");
  return settings;
}

std::vector<std::uint32_t> first_sphere_of_bodies(const std::vector<WallBodySpec>& walls) {
  std::vector<std::uint32_t> first(1, 0);
  for (const auto& wall : walls)
    first.push_back(first.back() + static_cast<std::uint32_t>(wall.centres.size()));
  return first;
}

std::vector<double> radii_of(const std::vector<WallBodySpec>& walls) {
  std::vector<double> radii;
  for (const auto& wall : walls) radii.push_back(wall.sphere_radius);
  return radii;
}

}  // namespace

Simulation::Simulation(const SimulationSettings& settings, std::vector<WallBodySpec> walls)
    : settings_(checked(settings)),
      workers_(settings_.threads),
      box_(settings_.period),
      list_({settings_.shape.sphere_radius, farthest_sphere(settings_.shape), settings_.skin},
            first_sphere_of_bodies(walls)),
      grain_loop_(make_grain_loop(settings_.grain_contact, settings_.lever_arm, settings_.spring_limit,
                                  settings_.shape.sphere_radius)),
      wall_loop_(make_wall_loop(settings_.wall_contact, settings_.lever_arm, settings_.spring_limit,
                                settings_.shape.sphere_radius, radii_of(walls))) {
  for (auto& wall : walls) {
    const double reach = settings_.shape.sphere_radius + wall.sphere_radius + settings_.skin;
    bodies_.emplace_back(std::move(wall), reach);
    body_motion_.push_back(bodies_.back().motion_at(0));
  }
  wall_loads_.resize(bodies_.size());
  clearance_.resize(bodies_.size());
  for (const auto& offset : settings_.shape.sphere_offsets)
    drag_inertia_ += Eigen::Vector3d::Constant(offset.squaredNorm()) - offset.cwiseAbs2();
  spheres_.spheres_per_grain = settings_.shape.spheres();
  sort_and_search();
}

void Simulation::add_grains(const std::vector<NewGrain>& added) {
  wrap_grains();
  const double before = energy().total();
  const std::size_t old_count = grains_.size();
  grains_.resize(old_count + added.size());
  motion_.resize(grains_.size());
  for (std::size_t k = 0; k < added.size(); ++k) {
    const std::size_t g = old_count + k;
    const NewGrain& grain = added[k];
    grains_.id[g] = next_id_++;
    grains_.position[g] = box_.wrapped(grain.position);
    grains_.velocity[g] = grain.velocity;
    // A single sphere has no orientation worth following: its body frame is the laboratory's.
    grains_.orientation[g] =
        settings_.shape.spheres() == 1 ? Quaternion(1, 0, 0, 0) : grain.orientation.normalized();
    grains_.spin[g] = rotation_matrix(grains_.orientation[g]).transpose() * grain.angular_velocity;
    grains_.force[g] = settings_.shape.mass * settings_.gravity;
    grains_.torque[g].setZero();
    motion_[g] = {grains_.position[g], grain.velocity, grain.angular_velocity};
  }
  sort_and_search();
  ledger_.added_energy += energy().total() - before;
}

std::size_t Simulation::remove_grains(const std::function<bool(const Eigen::Vector3d&)>& leaves) {
  std::vector<std::uint32_t> staying;
  for (std::uint32_t k = 0; k < grains_.size(); ++k)
    if (!leaves(box_.wrapped(grains_.position[k]))) staying.push_back(k);
  const std::size_t gone = grains_.size() - staying.size();
  if (gone == 0) return 0;
  wrap_grains();
  const double before = energy().total();
  search_in_order(staying);
  ledger_.added_energy += energy().total() - before;
  return gone;
}

void Simulation::set_motion(std::size_t body, std::function<BodyMotion(double)> motion) {
  bodies_.at(body).set_motion(std::move(motion));
  body_motion_[body] = bodies_[body].motion_at(time_);
}

Eigen::Vector3d Simulation::angular_velocity(std::size_t k) const {
  return rotation_matrix(grains_.orientation[k]) * grains_.spin[k];
}

void Simulation::step() {
  timers_.begin();
  ++step_;
  time_ = static_cast<double>(step_) * settings_.time_step;
  move_bodies();
  advance_grains();
  timers_.lap(Phase::advance);
  if (list_is_old()) {
    sort_and_search();
    timers_.lap(Phase::search);
  }
  place_images();
  compute_contacts();
  timers_.lap(Phase::contacts);
  finish_grains();
  book_step();
  timers_.lap(Phase::gather);
}

void Simulation::move_bodies() {
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (bodies_[b].moves()) body_motion_[b] = bodies_[b].motion_at(time_);
}

void Simulation::advance_grains() {
  auto& blocks = list_.blocks();
  workers_.for_each(blocks.size(), [&](std::size_t b) {
    tallies_[b].displacement = 0;
    for (std::size_t k = blocks[b].begin; k < blocks[b].end; ++k) {
      advance_grain(k);
      tallies_[b].displacement = std::max(tallies_[b].displacement, displacement_since_search(k));
    }
  });
}

void Simulation::advance_grain(std::size_t k) {
  const GrainShape& shape = settings_.shape;
  const double dt = settings_.time_step;
  const Eigen::Vector3d acceleration = grains_.force[k] / shape.mass;
  grains_.position[k] += grains_.velocity[k] * dt + acceleration * (0.5 * dt * dt);
  GrainMotion& motion = motion_[k];
  motion.position = grains_.position[k];
  // Forces depend on velocities: they see those that the present forces would lead to (OP-3).
  motion.velocity = grains_.velocity[k] + acceleration * dt;
  Eigen::Vector3d* spheres = &spheres_.position[k * shape.spheres()];
  if (!shape.rotates) {
    spheres[0] = grains_.position[k];
    return;
  }
  const Eigen::Vector3d rate = spin_rate(shape.inertia, grains_.spin[k], grains_.torque[k]);
  if (shape.spheres() == 1) {
    motion.angular_velocity = grains_.spin[k] + rate * dt;
    spheres[0] = grains_.position[k];
    return;
  }
  grains_.orientation[k] = advance_orientation(grains_.orientation[k], grains_.spin[k], rate, dt);
  const Eigen::Matrix3d to_lab = rotation_matrix(grains_.orientation[k]);
  motion.angular_velocity = to_lab * (grains_.spin[k] + rate * dt);
  for (std::size_t s = 0; s < shape.spheres(); ++s)
    spheres[s] = grains_.position[k] + to_lab * shape.sphere_offsets[s];
}

double Simulation::displacement_since_search(std::size_t k) const {
  const Eigen::Vector3d moved =
      grains_.position[k] - reference_.position[k] - reference_.drift * (time_ - reference_.time);
  if (settings_.shape.spheres() == 1) return moved.norm();
  // A sphere at distance r turns by at most 2 r |q - q_0|.
  return moved.norm() +
         2 * list_.settings().farthest_sphere * (grains_.orientation[k] - reference_.orientation[k]).norm();
}

ContactSum Simulation::gathered(std::size_t b, std::size_t k) const {
  const auto& blocks = list_.blocks();
  ContactSum sum = blocks[b].sums[k - blocks[b].begin];
  for (std::uint32_t f = list_.foreign_first()[k]; f < list_.foreign_first()[k + 1]; ++f) {
    const auto place = list_.foreign_sums()[f];
    const ContactSum& part = blocks[place.block].sums[place.slot];
    sum.force += part.force;
    sum.torque += part.torque;
    sum.rolling_load += part.rolling_load;
  }
  return sum;
}

void Simulation::compute_contacts() {
  const ContactScene scene = contact_scene();
  auto& blocks = list_.blocks();
  workers_.for_each(blocks.size(), [&](std::size_t b) {
    tallies_[b].start(bodies_.size());
    std::fill(blocks[b].sums.begin(), blocks[b].sums.end(), ContactSum{});
    grain_loop_->add_forces(blocks[b], scene, tallies_[b]);
    wall_loop_->add_forces(blocks[b], scene, tallies_[b]);
  });
}

void Simulation::finish_grains() {
  const auto& blocks = list_.blocks();
  workers_.for_each(blocks.size(), [&](std::size_t b) {
    for (std::size_t k = blocks[b].begin; k < blocks[b].end; ++k)
      finish_grain(k, gathered(b, k), tallies_[b]);
  });
}

void Simulation::finish_grain(std::size_t k, const ContactSum& contacts, BlockTally& tally) {
  const GrainShape& shape = settings_.shape;
  const double dt = settings_.time_step;
  const double drag = 6 * std::numbers::pi * settings_.air_viscosity * shape.sphere_radius;
  const double grain_drag = drag * static_cast<double>(shape.spheres());
  const Eigen::Vector3d air = -grain_drag * motion_[k].velocity;
  tally.drag_work += air.dot(motion_[k].velocity) * dt;

  const Eigen::Vector3d force = contacts.force + air + shape.mass * settings_.gravity;
  grains_.velocity[k] += (grains_.force[k] + force) * (0.5 * dt / shape.mass);
  grains_.force[k] = force;
  if (!shape.rotates) return;

  if (shape.spheres() == 1) {
    Eigen::Vector3d& spin = grains_.spin[k];
    spin = advance_spin(shape.inertia, spin, grains_.torque[k], contacts.torque, dt);
    grains_.torque[k] = contacts.torque;
    // Rolling friction (Eq. 2.11) stops a rotation but never reverses it within a step (OP-9).
    const double speed = spin.norm();
    if (contacts.rolling_load > 0 && speed > 0) {
      const double slower = std::max(0.0, speed - contacts.rolling_load * dt / shape.inertia[0]);
      tally.rolling_work += 0.5 * shape.inertia[0] * (slower * slower - speed * speed);
      spin *= slower / speed;
    }
    return;
  }
  const Eigen::Matrix3d to_lab = rotation_matrix(grains_.orientation[k]);
  const Eigen::Vector3d predicted_spin = to_lab.transpose() * motion_[k].angular_velocity;
  const Eigen::Vector3d air_torque = -drag * drag_inertia_.cwiseProduct(predicted_spin);
  tally.drag_work += air_torque.dot(predicted_spin) * dt;
  const Eigen::Vector3d torque = to_lab.transpose() * contacts.torque + air_torque;
  grains_.spin[k] = advance_spin(shape.inertia, grains_.spin[k], grains_.torque[k], torque, dt);
  grains_.torque[k] = torque;
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

ContactScene Simulation::contact_scene() const {
  return {spheres_, motion_, bodies_, body_motion_, settings_.shape.sphere_radius, settings_.time_step};
}

}  // namespace diefill::engine
