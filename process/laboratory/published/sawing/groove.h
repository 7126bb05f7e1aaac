// A wire in the groove of a crystal, with fluid or slurry between them (Bierwisch 2009, sections A.2.2 and
// A.3). Reduced units; the wire lies along y, z is up, and the groove's bottom is round about the origin.
#pragma once

#include <string>
#include <vector>

#include "process/laboratory/published/custom_run.h"
#include "process/laboratory/published/sawing/slurry.h"

namespace diefill::process::laboratory::sawing {

/// Shapes and how the wire moves. Lengths as published: wire 100 um, groove 140 um.
struct GrooveCase {
  double wire_radius = 10, groove_radius = 14;
  double top = 14;        ///< z of the lid that closes the groove: the fluid has no free surface
  double length = 8;      ///< periodic, along y
  double wire_start = 0;  ///< z of its axis
  double speed = 0;       ///< of the wire along y
  double pressure = 0;    ///< on the wire's projected area (OP-18), down; 0: the wire keeps its height
  double solids = 0;      ///< share of the slurry
  double grip = 1;        ///< DpdParameters::grip
  int settling = 2000, sampled = 4000;  ///< steps
  int instants = 0;                     ///< of the grains, kept for a film
};

/// A place in the gap below the wire and the fluid's mean speed along it there.
struct GapSpeed {
  double radius = 0, speed = 0;
};

/// Normal stress on the ingot in one stretch of its surface, over the tangential coordinate: 0 at the lowest
/// line, rising to both sides. That of the lid, where the wire does not reach, is taken off.
struct GrooveStress {
  double place = 0, width = 0, stress = 0;
};

/// Share of grains of one size by compressive stress in the process, N/mm^2.
struct GrainStress {
  double size = 0;
  double low = 0, middle = 0, high = 0;  ///< up to 5, up to 25, above
};

/// A particle in a slice across the wire, at the end of the run.
struct SectionPoint {
  enum class Part { fluid, grain, tool };
  Part part;
  double x, z;
};

struct GrooveFigures {
  std::vector<GapSpeed> gap;
  std::vector<GrooveStress> stress;
  std::vector<GrainStress> grains;
  std::vector<SectionPoint> section;
  std::vector<double> time, distance;  ///< wire to ingot, below the wire, over the whole run
  double mean_distance = 0;            ///< of the sampled steps
  double solids = 0;                   ///< share that found room
  double temperature = 0;
  double particle_steps = 0;
};

/// One line: all that the run's result depends on, but its seed.
std::string settings_text(const GrooveCase& one);
/// Particle steps, about.
double work_of(const GrooveCase& one);

/// Runs it; a film of the grains (groove_film.h) goes to the watch's folder. Throws CustomRunStopped.
GrooveFigures saw(const GrooveCase& one, std::uint64_t seed, CustomRunWatch& watch);

}  // namespace diefill::process::laboratory::sawing
