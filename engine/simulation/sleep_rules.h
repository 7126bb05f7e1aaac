// Which grains fall asleep and which wake: rules on the state, checked every few steps.
#pragma once

#include <Eigen/Geometry>

#include "engine/simulation/simulation_state.h"

namespace diefill::engine {

/// Steps between checks of sleeping grains.
inline constexpr std::uint64_t kStepsPerCheck = 10;

/// The body that sleepers move with, at the present time; one at rest where they stand still.
BodyMotion carrier_motion(const SimulationState& state);

/// Boxes (m) about the tools that move, or have since contacts were searched, a grain wider than they are.
/// What moves as sleepers do leaves them alone.
std::vector<Eigen::AlignedBox3d> moving_tools(const SimulationState& state);

/// J, of grain k against sleepers, which move with `carried` (m/s).
double kinetic_energy(const SimulationState& state, std::size_t k, const Eigen::Vector3d& carried);

/// Updates the counts of checks at which grains were slow against the carrier; forces must be up to date for
/// sleepers as well.
void check_grains(SimulationState& state);

/// Sleepers that forces or fast neighbours wake now. `rests`: as blocks_at_rest() gives it.
std::vector<std::uint32_t> disturbed(const SimulationState& state, const std::vector<std::uint8_t>& rests);
/// Sleepers in any of the boxes (m).
std::vector<std::uint32_t> sleepers_within(const SimulationState& state,
                                           const std::vector<Eigen::AlignedBox3d>& boxes);
/// Wakes these sleepers, and those that they touch.
void wake(SimulationState& state, const std::vector<std::uint32_t>& sleepers);

/// Grains that fall asleep now, none of them in any of the boxes (m): none while they are too few to be
/// worth a search of contacts.
std::vector<std::uint32_t> sleep_candidates(const SimulationState& state,
                                            const std::vector<Eigen::AlignedBox3d>& near_moving_tools);

/// 1 for each block of which neither pairs nor grains need work: its grains sleep, and all that they pair
/// with.
std::vector<std::uint8_t> blocks_at_rest(const SimulationState& state);

}  // namespace diefill::engine
