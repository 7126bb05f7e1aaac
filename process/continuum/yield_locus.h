// What a shear test says about a powder: the yield locus of a consolidated bed, its Mohr circles and the
// figures of flow that follow from them (Jenike's procedure; Kottlan 2018, sections 2.7.4 and 3.4). SI
// units.
#pragma once

#include <vector>

namespace diefill::process::continuum {

/// On the failure plane, Pa.
struct StressPoint {
  double normal = 0, shear = 0;
};

/// tau = slope sigma + cohesion.
struct YieldLocus {
  double slope = 0, cohesion = 0;  ///< 1, Pa

  double at(double normal) const { return slope * normal + cohesion; }
};

/// Of stresses at failure, centre on the axis of normal stress, Pa.
struct MohrCircle {
  double centre = 0, radius = 0;

  double major() const { return centre + radius; }  ///< major principal stress
  double minor() const { return centre - radius; }
};

/// The least-squares line through the points; NaN for fewer than two normal stresses.
YieldLocus yield_locus_through(const std::vector<StressPoint>& points);

/// Touches the locus with no minor stress: its major one is the unconfined yield strength f_c =
/// 2 tau_0 (sqrt(1 + k^2) + k).
MohrCircle unconfined_circle(const YieldLocus& locus);

/// Of steady flow: through the pre-shear point, touching the locus on its left. Where that point lies above
/// the locus, the circle that touches it at the point's normal stress.
MohrCircle steady_circle(const YieldLocus& locus, const StressPoint& preshear);

/// deg, effective angle of internal friction: sin = radius over centre of the circle of steady flow.
double effective_angle(const MohrCircle& steady);

/// ff_c = sigma_1 / f_c: below 1 not flowing, 1 to 2 very cohesive, 2 to 4 cohesive, 4 to 10 easy flowing,
/// above 10 free flowing. NaN where the locus has no positive cohesion.
double flow_function(const YieldLocus& locus, const StressPoint& preshear);

}  // namespace diefill::process::continuum
