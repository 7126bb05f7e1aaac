// How much powder there is and how much of it sleeps.
#pragma once

#include <cstddef>
#include <cstdint>

namespace diefill::engine {

class Simulation;

/// Spheres of all grains.
std::size_t sphere_count(const Simulation& simulation);

/// kg, of all grains, added in their order.
double powder_mass(const Simulation& simulation);

/// Sleeping grains; none where the settings put none to sleep.
std::size_t sleepers(const Simulation& simulation);
bool asleep(const Simulation& simulation, std::size_t k);
/// Sphere-steps that blocks at rest have saved so far.
std::uint64_t sphere_steps_left_out(const Simulation& simulation);

}  // namespace diefill::engine
