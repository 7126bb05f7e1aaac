// A fine sphere that rolls down the groove between two fixed large ones that touch: the case in which
// friction integrated with velocities half a step old holds fine grains fast (Vyas, Ottino, Lueptow and
// Umbanhowar 2025, Computer Physics Communications 310, 109524), with the law and sizes of
// their example.
#pragma once

#include "engine/laws/law_parameters.h"

namespace diefill::process::laboratory {

inline constexpr double kFineRadius = 2.5e-4, kFineDensity = 2500;  // m, kg/m^3

/// Linear spring of 10 kN/m, restitution 0.5, friction 0.5 with a spring of 8235 N/m.
engine::laws::LawParameters groove_law();

/// The sphere lies in the groove at rest, `start` (rad) off the highest place.
struct GrooveCase {
  double ratio = 20;      ///< radius of the large spheres over that of the fine one
  double start = 0.0175;  ///< rad
};

/// s in which the sphere comes from `groove.start` to `angle` (rad), if it rolls on both without slipping: an
/// inverted pendulum of length rho, the distance of its centre from the line of the large ones', slowed by
/// the factor 1 + 2/5 ((R_L + R) / rho)^2 as it turns.
double rolling_time(const GrooveCase& groove, double angle);

/// Where the sphere is, seen along the line through the large ones' centres.
struct GroovePlace {
  double angle = 0;     ///< rad, from the highest place
  double distance = 0;  ///< from the line, over rho: 1 while it is in the groove
};

/// After `time` (s) in steps of `time_step` (s).
GroovePlace place_by_engine(const GrooveCase& groove, double time, double time_step);

/// The same by plain velocity Verlet, whose relative velocities are those of half a step ago while normals
/// are those of the step's end.
GroovePlace place_by_half_steps(const GrooveCase& groove, double time, double time_step);

}  // namespace diefill::process::laboratory
