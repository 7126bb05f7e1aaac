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
  const double ratio = simulation.deepest_overlap() / radius;
  if (ratio > limits_.forbidden_overlap)
    throw OutOfRange(
        line("two spheres overlap by %.2f of their radius at t = %.6g s (limit %.2f): grains are too soft "
             "for this speed or load; raise reduced_modulus or take a shorter time step (now %.3g s)",
             ratio, simulation.time(), limits_.forbidden_overlap, simulation.settings().time_step));
  if (ratio > limits_.comfortable_overlap && !warned_of_overlap_) {
    warned_of_overlap_ = true;
    warnings_.push_back(
        line("overlap reached %.2f of the sphere radius at t = %.6g s; up to %.2f is comfortable", ratio,
             simulation.time(), limits_.comfortable_overlap));
  }
}

void Health::check_time_step(const Simulation& simulation) const {
  const auto& settings = simulation.settings();
  if (simulation.deepest_overlap() <= 0) return;
  const double critical =
      critical_time_step_at_overlap(settings.shape, settings.grain_contact, simulation.deepest_overlap());
  if (settings.time_step > critical)
    throw OutOfRange(
        line("the time step of %.3g s is above the critical one of %.3g s for the overlap of %.3g m "
             "reached at t = %.6g s; take a shorter step",
             settings.time_step, critical, simulation.deepest_overlap(), simulation.time()));
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
