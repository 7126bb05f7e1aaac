// Stress that contacts carry through the powder, grain by grain.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace diefill::engine {

class Simulation;

/// J: stress of each grain (in the order of Grains) times the volume it is spread over, from the contacts of
/// the last step (Bierwisch 2009, Eq. 3.8, without the part of the grains' own motion): sum of force times
/// arm from the grain's centre, which for single spheres is R - h/2 along the normal. Compression is
/// negative.
std::vector<Eigen::Matrix3d> contact_stress_times_volume(const Simulation& simulation);

}  // namespace diefill::engine
