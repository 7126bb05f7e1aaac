#include "engine/limits/validity_monitor.h"

#include <cmath>
#include <cstdio>

#include "engine/limits/time_step.h"
#include "engine/limits/worst_places.h"
#include "engine/observe/energy_balance.h"
#include "engine/observe/powder_figures.h"
#include "engine/simulation/simulation.h"

namespace diefill::engine {

namespace {

template <class... Values>
std::string line(const char* format, Values... values) {
  char text[640];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// ", deepest now between grain 1 at (..) mm and grain 2", or nothing.
std::string deepest_text(const Simulation& simulation) {
  const DeepestPair pair = deepest_pair(simulation);
  if (pair.overlap <= 0) return {};
  const Grains& grains = simulation.grains();
  return ", deepest now between " + grain_text(grains, pair.first) + " and grain " +
         std::to_string(grains.id[pair.second]);
}

/// "; the fastest, grain 1 at (..) mm, moves at 2 m/s".
std::string fastest_text(const Simulation& simulation) {
  const auto fastest = fastest_grain(simulation.grains());
  return line("; the fastest, %s, moves at %.3g m/s", grain_text(simulation.grains(), fastest.grain).c_str(),
              fastest.speed);
}

/// Critical time step (s) at the overlaps that grains have now.
double critical_now(const Simulation& simulation) {
  const DeepestOverlap& deepest = simulation.overlaps();
  return critical_time_step_at_overlap(simulation.types(), simulation.settings().contact, deepest.grains,
                                       deepest.grains_over_radius);
}

/// The same of a collision at `speed` (m/s).
double critical_of_impact(const Simulation& simulation, double speed) {
  return collision_time_step(simulation.types(), simulation.settings().contact, speed);
}

}  // namespace

void ValidityMonitor::warn_once(bool& warned, const std::string& warning) {
  if (!warned) state_.texts.push_back(warning);
  warned = true;
}

void ValidityMonitor::check(const Simulation& simulation) {
  check_numbers(simulation);
  check_overlap(simulation);
  check_time_step(simulation);
  check_speed(simulation);
  check_contacts(simulation);
  check_energy(simulation);
}

void ValidityMonitor::check_numbers(const Simulation& simulation) const {
  const Grains& grains = simulation.grains();
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (!grains.position[k].allFinite() || !grains.velocity[k].allFinite() || !grains.spin[k].allFinite())
      throw OutOfRange(line(
          "grain %llu has no finite position or velocity at t = %.6g s: the run is unstable; take a "
          "shorter time step (now %.3g s)",
          static_cast<unsigned long long>(grains.id[k]), simulation.time(), simulation.settings().time_step));
}

void ValidityMonitor::check_overlap(const Simulation& simulation) const {
  const double grains = simulation.overlaps_of_run().grains_over_radius;
  const double walls = simulation.overlaps_of_run().walls_over_radius;
  if (grains > limits_.largest_overlap)
    throw OutOfRange(line(
        "two spheres overlap by %.2f of their radius by t = %.6g s%s (limit %.2f: STABILITY.md, "
        "stiffness): grains are too soft for this speed or load; raise reduced_modulus or take a shorter "
        "time step (now %.3g s)",
        grains, simulation.time(), deepest_text(simulation).c_str(), limits_.largest_overlap,
        simulation.settings().time_step));
  if (walls > limits_.largest_wall_overlap)
    throw OutOfRange(
        line("a sphere is pressed into a wall by %.2f of its radius by t = %.6g s (limit %.2f), as when a "
             "tool pinches a grain: slow the tool down, raise reduced_modulus or take a shorter time step "
             "(now %.3g s)",
             walls, simulation.time(), limits_.largest_wall_overlap, simulation.settings().time_step));
}

std::vector<std::string> overlap_warnings(const Simulation& simulation, const ValidityLimits& limits) {
  const double grains = simulation.overlaps_of_run().grains_over_radius;
  const double walls = simulation.overlaps_of_run().walls_over_radius;
  std::vector<std::string> warnings;
  if (grains > limits.warning_overlap)
    warnings.push_back(
        line("overlap among grains reached %.3g of the sphere radius; up to %.2f is acceptable", grains,
             limits.warning_overlap));
  if (walls > limits.largest_overlap)
    warnings.push_back(
        line("a tool pinched a grain: overlap with a wall reached %.3g of the sphere radius", walls));
  return warnings;
}

void ValidityMonitor::check_time_step(const Simulation& simulation) const {
  const auto& settings = simulation.settings();
  if (simulation.overlaps().grains <= 0) return;
  const double critical = critical_now(simulation);
  if (settings.time_step > critical)
    throw OutOfRange(
        line("the time step of %.3g s is above the critical one of %.3g s for the overlap of %.3g m "
             "reached at t = %.6g s%s (STABILITY.md, time step); take a shorter step",
             settings.time_step, critical, simulation.overlaps().grains, simulation.time(),
             deepest_text(simulation).c_str()));
}

void ValidityMonitor::check_speed(const Simulation& simulation) {
  const auto& settings = simulation.settings();
  const auto fastest = fastest_for_its_size(simulation);
  if (fastest.speed <= 0) return;
  const double way = fastest.speed * settings.time_step / simulation.shape_of(fastest.grain).sphere_radius;
  const std::string who = grain_text(simulation.grains(), fastest.grain);
  if (way > limits_.largest_displacement)
    throw OutOfRange(
        line("%s moves at %.3g m/s at t = %.6g s, %.2f of its sphere radius in a step (limit %.2f): it would "
             "pass through other grains undetected; the run is unstable or %s%.3g s too long: take a shorter "
             "one",
             who.c_str(), fastest.speed, simulation.time(), way, limits_.largest_displacement, kStepTooLong,
             settings.time_step));
  const double critical = critical_of_impact(simulation, 2 * fastest.speed);
  if (settings.time_step > limits_.warning_step * critical)
    warn_once(
        state_.speed,
        line("%s moved at %.3g m/s at t = %.6g s: the critical step of its collisions is %.3g s; the run's "
             "step is %.3g s, and up to %.2f of the critical one is acceptable (STABILITY.md, time step)",
             who.c_str(), fastest.speed, simulation.time(), critical, settings.time_step,
             limits_.warning_step));
}

void ValidityMonitor::check_contacts(const Simulation& simulation) {
  const auto spheres = static_cast<double>(sphere_count(simulation));
  if (spheres <= 0) return;
  const double contacts = static_cast<double>(simulation.touching_pairs()) / spheres;
  if (contacts > limits_.largest_contacts)
    throw OutOfRange(line(
        "%.1f contacts a sphere at t = %.6g s%s (limit %.0f; equal spheres have room for 6): grains lie "
        "inside each other; raise reduced_modulus, take a shorter time step (now %.3g s) or coarser wall "
        "spheres",
        contacts, simulation.time(), deepest_text(simulation).c_str(), limits_.largest_contacts,
        simulation.settings().time_step));
  if (contacts > limits_.warning_contacts)
    warn_once(state_.contacts,
              line("%.1f contacts a sphere at t = %.6g s; up to %.0f are acceptable, equal spheres have room "
                   "for 6",
                   contacts, simulation.time(), limits_.warning_contacts));
}

void ValidityMonitor::check_energy(const Simulation& simulation) {
  const double error = energy_balance_error(simulation);
  if (std::isnan(error))
    throw OutOfRange(
        line("the energy exchanged is no finite number at t = %.6g s: the run is unstable; take a "
             "shorter time step (now %.3g s)",
             simulation.time(), simulation.settings().time_step));
  if (error > limits_.energy_error)
    throw OutOfRange(
        line("energy grew by %.1f %% of the energy exchanged with no work to explain it at t = %.6g s "
             "(limit %.1f %%: STABILITY.md, time step): %s%.3g s is too long%s",
             100 * error, simulation.time(), 100 * limits_.energy_error, kStepTooLong,
             simulation.settings().time_step, fastest_text(simulation).c_str()));
  if (error > limits_.warning_energy_error)
    warn_once(state_.energy,
              line("energy grew by %.1f %% of the energy exchanged with no work to explain it by t = %.6g s; "
                   "up to %.1f %% is acceptable (STABILITY.md, time step)",
                   100 * error, simulation.time(), 100 * limits_.warning_energy_error));
}

}  // namespace diefill::engine
