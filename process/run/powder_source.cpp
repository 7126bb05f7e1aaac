#include "process/run/powder_source.h"

#include <algorithm>
#include <cmath>

#include "engine/simulation/simulation.h"
#include "process/powder/material.h"
#include "process/powder/powder_mixture.h"
#include "process/powder/random.h"
#include "process/tooling/half_model.h"

namespace diefill::process {

namespace {

/// m/s, the body that a box goes along with carries its grains.
Eigen::Vector3d velocity_of(const engine::BodyMotion* body, const Eigen::Vector3d& place) {
  return body != nullptr ? body->velocity_at(place) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

/// Of the grain of that number among those that a step lets in: multiples of the golden ratio fill the range
/// of shares evenly.
engine::TypeNumber type_of(const std::vector<engine::CutClass>& shares, std::size_t number) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  const double place = std::fmod((static_cast<double>(number) + 0.5) * kGoldenRatio, 1.0);
  double below = 0;
  std::size_t last = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    below += shares[k].number_share;
    if (shares[k].number_share > 0) last = k;
    if (place < below) return static_cast<engine::TypeNumber>(k);
  }
  return static_cast<engine::TypeNumber>(last);
}

/// `way` (m) from one grain to another, or to its nearest image where the scene repeats.
Eigen::Vector3d to_nearest_image(Eigen::Vector3d way, const NumericsSpec& numerics) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& period = numerics.period[axis];
    double& along = way[static_cast<Eigen::Index>(axis)];
    if (period) along -= *period * std::round(along / *period);
  }
  return way;
}

/// m, anywhere in the box.
Eigen::Vector3d random_place(const geometry::Box& box, Random& random) {
  const Eigen::Vector3d half = 0.5 * box.size(), middle = box.lower + half;
  const Eigen::Vector3d offset(random.symmetric(), random.symmetric(), random.symmetric());
  return middle + offset.cwiseProduct(half);
}

/// Places (m) and bounding radii (m) of the grains whose nearest image is closer to `middle` (m) than `reach`
/// (m).
std::vector<std::pair<Eigen::Vector3d, double>> grains_near(const engine::Simulation& simulation,
                                                            const NumericsSpec& numerics,
                                                            const Eigen::Vector3d& middle, double reach) {
  std::vector<std::pair<Eigen::Vector3d, double>> near;
  const engine::Grains& grains = simulation.grains();
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (to_nearest_image(grains.position[k] - middle, numerics).norm() < reach)
      near.emplace_back(grains.position[k], simulation.shape_of(k).bounding_radius());
  return near;
}

}  // namespace

PowderSource::PowderSource(const Scene& scene, const Tooling& tooling) : scene_(scene), tooling_(tooling) {
  for (std::size_t k = 0; k < scene.steps.size(); ++k)
    if (scene.steps[k]->inflow() != nullptr) sources_.push_back(k);
  if (!any()) return;
  for (const Tool& tool : tooling.tools) solids_.push_back(tool.solid());
}

std::size_t PowderSource::feed(engine::Simulation& simulation, Schedule& schedule) const {
  std::size_t all = 0;
  for (const std::size_t k : sources_) {
    const StepState& state = schedule.of_step(k);
    if (!state.is_active() || state.stop_requested >= 0) continue;
    const PowderInflow& inflow = *scene_.steps[k]->inflow();
    const std::size_t wanted = owed(inflow, state, simulation);
    if (wanted == 0) continue;
    // Any mixing of the three numbers will do that gives every call its own random numbers.
    const std::uint64_t seed = (scene_.seed * 1000003 + k) * 0x9e3779b97f4a7c15ULL + simulation.steps();
    const auto grains = placed(inflow, wanted, state.grains_fed, seed, simulation);
    if (grains.empty()) continue;
    simulation.add_grains(grains);
    schedule.count_inflow(k, grains.size());
    all += grains.size();
  }
  return all;
}

std::size_t PowderSource::owed(const PowderInflow& inflow, const StepState& state,
                               const engine::Simulation& simulation) const {
  const PowderSpec& powder =
      inflow.powder.empty() ? scene_.powder : powder_of(scene_, *powder_named(scene_, inflow.powder));
  const double radius = mean_grain(powder, scene_.coarse_graining).bounding_radius();
  const double mass = copies(tooling_) * mean_grain_mass(scene_, inflow, simulation);
  const double room = start_box(tooling_, inflow, radius).size().cwiseMax(2 * radius).prod();
  double wanted = room / std::pow(2 * radius, 3);
  const auto come = static_cast<double>(state.grains_fed);
  if (inflow.rate)
    wanted = std::min(wanted, *inflow.rate * (simulation.time() - state.started) / mass - come);
  if (inflow.mass) wanted = std::min(wanted, std::ceil(*inflow.mass / mass) - come);
  return static_cast<std::size_t>(std::max(0.0, std::floor(wanted)));
}

std::vector<engine::NewGrain> PowderSource::placed(const PowderInflow& inflow, std::size_t wanted,
                                                   std::size_t come, std::uint64_t seed,
                                                   const engine::Simulation& simulation) const {
  const double apart = 2 * simulation.types().largest_grain();
  const engine::BodyMotion* body =
      inflow.with.empty() ? nullptr : &simulation.body_motion(tooling_.index_of(inflow.with));
  const Eigen::Vector3d half = 0.5 * (inflow.upper - inflow.lower), centre = inflow.lower + half;
  const Eigen::Vector3d middle = body != nullptr ? body->point(centre) : centre;
  auto near = grains_near(simulation, scene_.numerics, middle, half.norm() + apart);
  const auto shares = number_shares(scene_, inflow);
  Random random(seed);
  std::vector<engine::NewGrain> grains;
  const std::size_t tries = 10 * wanted + 20;
  for (std::size_t n = 0; n < tries && grains.size() < wanted; ++n) {
    const engine::TypeNumber kind = type_of(shares, come + grains.size());
    const double radius = simulation.types().shape(kind).bounding_radius();
    const Eigen::Vector3d in_body = random_place(start_box(tooling_, inflow, radius), random);
    const Eigen::Vector3d place = body != nullptr ? body->point(in_body) : in_body;
    const auto touches = [&](const std::pair<Eigen::Vector3d, double>& other) {
      const Eigen::Vector3d way = to_nearest_image(other.first - place, scene_.numerics);
      return way.norm() < radius + other.second;
    };
    if (std::any_of(near.begin(), near.end(), touches) || !free_of_tools(place, radius, simulation)) continue;
    engine::NewGrain grain;
    grain.kind = kind;
    grain.position = place;
    grain.velocity = inflow.velocity + velocity_of(body, place);
    grain.orientation = random.direction<4>();
    near.emplace_back(place, radius);
    grains.push_back(grain);
  }
  return grains;
}

bool PowderSource::free_of_tools(const Eigen::Vector3d& place, double radius,
                                 const engine::Simulation& simulation) const {
  for (std::size_t k = 0; k < solids_.size(); ++k) {
    const engine::BodyMotion& pose = simulation.body_motion(k);
    const Eigen::Vector3d in_body = pose.rotation.transpose() * (place - pose.translation);
    if (solids_[k].signed_distance(in_body) < radius) return false;
  }
  return true;
}

}  // namespace diefill::process
