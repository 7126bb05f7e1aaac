#include "process/run/probes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/observe/energy_balance.h"
#include "engine/simulation/simulation.h"
#include "process/measure/cavity_position.h"
#include "process/tooling/die_frame.h"
#include "process/tooling/grain_tally.h"
#include "process/tooling/half_model.h"

namespace diefill::process {

namespace {

struct Heading {
  std::vector<std::string> columns, units;
};

/// Columns after the time.
Heading heading(ProbeQuantity quantity) {
  switch (quantity) {
    case ProbeQuantity::load:
      return {{"force x", "force y", "force z", "torque x", "torque y", "torque z", "shift x", "shift y",
               "shift z"},
              {"N", "N", "N", "N m", "N m", "N m", "m", "m", "m"}};
    case ProbeQuantity::flow:
      return {{"mass", "mass rate"}, {"kg", "kg/s"}};
    case ProbeQuantity::filled_mass:
      return {{"filled mass"}, {"kg"}};
    case ProbeQuantity::fill_level:
      return {{"mean level", "lowest level"}, {"m", "m"}};
    case ProbeQuantity::energy:
      return {{"kinetic", "height", "contacts", "balance error"}, {"J", "J", "J", "1"}};
  }
  throw std::logic_error("a quantity of a probe without a heading");
}

double mass_beyond(const ProbeSpec& probe, const engine::Simulation& simulation, const Tooling& tooling) {
  GrainTally beyond;
  const engine::Grains& grains = simulation.grains();
  for (std::size_t k = 0; k < grains.size(); ++k)
    visit_images(tooling, grains.position[k], [&](const Eigen::Vector3d& place) {
      if ((place - probe.origin).dot(probe.normal) > 0) beyond.add(grains.type_of(k));
    });
  return beyond.mass(simulation.types());
}

/// How many of a grain at `place` (m) and its image in a half model lie beyond the probe's plane.
double copies_beyond(const ProbeSpec& probe, const Tooling& tooling, const Eigen::Vector3d& place) {
  double count = 0;
  visit_images(tooling, place, [&](const Eigen::Vector3d& copy) {
    if ((copy - probe.origin).dot(probe.normal) > 0) ++count;
  });
  return count;
}

/// Whole time steps between two rows.
std::uint64_t steps_between(const ProbeSpec& probe, double time_step) {
  return static_cast<std::uint64_t>(std::max(1LL, std::llround(probe.interval / time_step)));
}

}  // namespace

Probes::Probes(const Scene& scene, const Tooling& tooling)
    : scene_(scene),
      tooling_(tooling),
      specs_(scene.probes),
      states_(scene.probes.size()),
      rows_(scene.probes.size()) {}

void Probes::begin(const engine::Simulation& simulation) {
  for (std::size_t k = 0; k < specs_.size(); ++k)
    if (specs_[k].quantity == ProbeQuantity::flow)
      states_[k].beyond = mass_beyond(specs_[k], simulation, tooling_);
}

void Probes::observe(const engine::Simulation& simulation) {
  for (std::size_t k = 0; k < specs_.size(); ++k) {
    ProbeState& state = states_[k];
    ++state.steps;
    if (specs_[k].quantity == ProbeQuantity::load) {
      const std::size_t body = tooling_.index_of(specs_[k].tool);
      const engine::WallLoad load = whole_load(tooling_, simulation.wall_load(body));
      state.force += load.force;
      // About the laboratory's origin, which stays where it is.
      state.torque += load.torque + simulation.body_motion(body).translation.cross(load.force);
    }
    if (simulation.steps() % steps_between(specs_[k], simulation.settings().time_step) != 0) continue;
    add_row(k, simulation);
    state.force.setZero();
    state.torque.setZero();
    state.steps = 0;
  }
}

std::uint64_t Probes::next_sync_step(std::uint64_t step, double time_step) const {
  std::uint64_t next = std::numeric_limits<std::uint64_t>::max();
  for (const ProbeSpec& spec : specs_) {
    const std::uint64_t every = steps_between(spec, time_step);
    if (spec.quantity != ProbeQuantity::load) next = std::min(next, (step / every + 1) * every);
  }
  return next;
}

bool Probes::needs_contacts(std::uint64_t step, double time_step) const {
  return std::any_of(specs_.begin(), specs_.end(), [&](const ProbeSpec& spec) {
    return spec.quantity == ProbeQuantity::energy && step % steps_between(spec, time_step) == 0;
  });
}

void Probes::add_row(std::size_t k, const engine::Simulation& simulation) {
  const ProbeSpec& spec = specs_[k];
  const ProbeState& state = states_[k];
  std::vector<double>& rows = rows_[k];
  const auto append = [&rows](std::initializer_list<double> values) { rows.insert(rows.end(), values); };
  append({simulation.time()});
  const double steps = static_cast<double>(state.steps);
  switch (spec.quantity) {
    case ProbeQuantity::load: {
      const Eigen::Vector3d force = state.force / steps, torque = state.torque / steps;
      append({force[0], force[1], force[2], torque[0], torque[1], torque[2]});
      const std::size_t body = tooling_.index_of(spec.tool);
      const Eigen::Vector3d origin = tooling_.tools[body].spec.position;
      const Eigen::Vector3d shift = simulation.body_motion(body).point(origin) - origin;
      return append({shift[0], shift[1], shift[2]});
    }
    case ProbeQuantity::flow: {
      const double mass = mass_beyond(spec, simulation, tooling_) + state.gone - state.beyond;
      const double before = rows.size() > 3 ? rows[rows.size() - 3] : 0;
      append({mass, (mass - before) / (steps * simulation.settings().time_step)});
      return;
    }
    case ProbeQuantity::filled_mass:
      return append({filled_mass(simulation, tooling_)});
    case ProbeQuantity::fill_level: {
      const auto level = fill_level(simulation);
      return append({level[0], level[1]});
    }
    case ProbeQuantity::energy: {
      const engine::Energy energy = engine::energy_of(simulation);
      const double all = copies(tooling_);
      return append({all * energy.kinetic(), all * energy.height, all * energy.contacts,
                     engine::energy_balance_error(simulation)});
    }
  }
}

std::vector<double> Probes::fill_level(const engine::Simulation& simulation) const {
  const results::CavityState cavity = cavity_state(tooling_.cavity);
  const DieFrame frame = die_frame(simulation, tooling_);
  const double width = 2 * scene_.powder.grain_diameter;
  const Eigen::Vector3d size = cavity.upper_corner - cavity.lower_corner;
  const auto across = static_cast<std::size_t>(std::max(1.0, std::ceil(size[0] / width))),
             deep = static_cast<std::size_t>(std::max(1.0, std::ceil(size[1] / width)));
  std::vector<double> highest(across * deep, 0.0);
  const auto diameters = grain_diameters(scene_.powder);
  double radius = 0;
  const auto raise = [&](const Eigen::Vector3d& position) {
    const Eigen::Vector3d place = frame.point(position);
    if (!lies_in_cavity(cavity, place)) return;
    const Eigen::Vector3d from_corner = place - cavity.lower_corner;
    const auto column = std::min(static_cast<std::size_t>(from_corner[0] / width), across - 1),
               row = std::min(static_cast<std::size_t>(from_corner[1] / width), deep - 1);
    double& level = highest[row * across + column];
    level = std::max(level, std::min(from_corner[2] + radius, size[2]));
  };
  const engine::Grains& grains = simulation.grains();
  for (std::size_t k = 0; k < grains.size(); ++k) {
    radius = 0.5 * diameters[grains.type_of(k)];
    visit_images(tooling_, grains.position[k], raise);
  }
  double sum = 0, lowest = size[2], count = 0;
  for (std::size_t n = 0; n < highest.size(); ++n) {
    const Eigen::Vector2d middle =
        cavity.lower_corner.head<2>() +
        width * Eigen::Vector2d(static_cast<double>(n % across) + 0.5, static_cast<double>(n / across) + 0.5);
    if (!tooling_.cavity.footprint.covers(middle)) continue;
    sum += highest[n];
    lowest = std::min(lowest, highest[n]);
    ++count;
  }
  return count > 0 ? std::vector<double>{sum / count, lowest} : std::vector<double>{0, 0};
}

void Probes::count_removed(const Eigen::Vector3d& position, double mass, double sign) {
  for (std::size_t k = 0; k < specs_.size(); ++k)
    if (specs_[k].quantity == ProbeQuantity::flow)
      states_[k].gone += sign * copies_beyond(specs_[k], tooling_, position) * mass;
}

void Probes::count_wrapped(const Eigen::Vector3d& before, const Eigen::Vector3d& now, double mass) {
  for (std::size_t k = 0; k < specs_.size(); ++k)
    if (specs_[k].quantity == ProbeQuantity::flow)
      states_[k].gone +=
          mass * (copies_beyond(specs_[k], tooling_, before) - copies_beyond(specs_[k], tooling_, now));
}

ProbesState Probes::state() const {
  ProbesState kept{states_, {}};
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    kept.probes[k].numbers = rows_[k].size();
    kept.rows.insert(kept.rows.end(), rows_[k].begin(), rows_[k].end());
  }
  return kept;
}

void Probes::restore(const ProbesState& state) {
  if (state.probes.size() != specs_.size())
    throw std::invalid_argument("the checkpoint has a different number of probes");
  states_ = state.probes;
  auto from = state.rows.begin();
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const auto to = from + static_cast<std::ptrdiff_t>(states_[k].numbers);
    rows_[k].assign(from, to);
    from = to;
  }
}

std::vector<results::ProbeSeries> Probes::series() const {
  std::vector<results::ProbeSeries> all;
  for (std::size_t k = 0; k < specs_.size(); ++k) {
    const Heading names = heading(specs_[k].quantity);
    results::ProbeSeries series;
    series.name = specs_[k].name;
    series.columns = {"time"};
    series.units = {"s"};
    series.columns.insert(series.columns.end(), names.columns.begin(), names.columns.end());
    series.units.insert(series.units.end(), names.units.begin(), names.units.end());
    series.values = rows_[k];
    all.push_back(std::move(series));
  }
  return all;
}

}  // namespace diefill::process
