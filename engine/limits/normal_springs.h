// Normal stiffness and damping of a contact, by whichever law a simulation uses: to judge whether a time
// step resolves it. Evaluates the law itself and is slow; the pair loop does not use it.
#pragma once

#include <cstddef>

namespace diefill::engine {

class Simulation;

/// Of the normal force at one overlap.
struct NormalSpring {
  double stiffness = 0;  ///< N/m
  double damping = 0;    ///< kg/s
};

/// Of two spheres (numbers in SphereField) that overlap by `overlap` (m), as on first loading.
NormalSpring spring_between(const Simulation& simulation, std::size_t sphere, std::size_t other,
                            double overlap);

/// Of a sphere and a part of `body` (number in Simulation::bodies()).
NormalSpring spring_at_tool(const Simulation& simulation, std::size_t sphere, std::size_t body,
                            double overlap);

}  // namespace diefill::engine
