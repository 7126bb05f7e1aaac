#include "engine/health.h"

#include <cmath>
#include <cstdio>

#include "engine/time_step.h"

namespace diefill::engine {

namespace {

template <class... Values>
std::string line(const char* format, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

void Health::check(const Simulation& simulation) {
  check_numbers(simulation);
  check_overlap(simulation);
  check_time_step(simulation);
  check_energy(simulation);
}

void Health::check_numbers(const Simulation& simulation) const {
  const Grains& grains = simulation.grains();
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (!grains.position[k].allFinite() || !grains.velocity[k].allFinite() || !grains.spin[k].allFinite())
      throw OutOfRange(line(
          "grain %llu has no finite position or velocity at t = %.6g s: the run is unstable; take a "
          "shorter time step (now %.3g s)",
          static_cast<unsigned long long>(grains.id[k]), simulation.time(), simulation.settings().time_step));
}

void Health::check_overlap(const Simulation& simulation) {
  const double radius = simulation.settings().shape.sphere_radius;
  const double grains = simulation.overlaps_of_run().grains / radius;
  const double walls = simulation.overlaps_of_run().walls / radius;
  if (grains > limits_.forbidden_overlap)
    throw OutOfRange(
        line("two spheres overlap by %.2f of their radius by t = %.6g s (limit %.2f): grains are too soft "
             "for this speed or load; raise reduced_modulus or take a shorter time step (now %.3g s)",
             grains, simulation.time(), limits_.forbidden_overlap, simulation.settings().time_step));
  if (walls > limits_.forbidden_wall_overlap)
    throw OutOfRange(
        line("a sphere is pressed into a wall by %.2f of its radius by t = %.6g s (limit %.2f), as when a "
             "tool pinches a grain: slow the tool down, raise reduced_modulus or take a shorter time step "
             "(now %.3g s)",
             walls, simulation.time(), limits_.forbidden_wall_overlap, simulation.settings().time_step));
  warn_of_overlap(grains, walls, simulation.time());
}

void Health::warn_of_overlap(double grains, double walls, double time) {
  if (grains > limits_.comfortable_overlap && !warned_of_overlap_) {
    warned_of_overlap_ = true;
    warnings_.push_back(
        line("overlap among grains reached %.2f of the sphere radius by t = %.6g s; up to %.2f is "
             "comfortable",
             grains, time, limits_.comfortable_overlap));
  }
  if (walls > limits_.forbidden_overlap && !warned_of_pinch_) {
    warned_of_pinch_ = true;
    warnings_.push_back(
        line("a tool pinched a grain by t = %.6g s: overlap with a wall reached %.2f of the sphere "
             "radius",
             time, walls));
  }
}

void Health::check_time_step(const Simulation& simulation) const {
  const auto& settings = simulation.settings();
  if (simulation.overlaps().grains <= 0) return;
  const double critical =
      critical_time_step_at_overlap(settings.shape, settings.grain_contact, simulation.overlaps().grains);
  if (settings.time_step > critical)
    throw OutOfRange(
        line("the time step of %.3g s is above the critical one of %.3g s for the overlap of %.3g m "
             "reached at t = %.6g s; take a shorter step",
             settings.time_step, critical, simulation.overlaps().grains, simulation.time()));
}

void Health::check_energy(const Simulation& simulation) const {
  const double error = simulation.energy_balance_error();
  if (error > limits_.energy_error)
    throw OutOfRange(
        line("energy grew by %.1f %% of what was turned over with no work to explain it at t = %.6g s "
             "(limit %.1f %%): the time step of %.3g s is too long",
             100 * error, simulation.time(), 100 * limits_.energy_error, simulation.settings().time_step));
}

}  // namespace diefill::engine
