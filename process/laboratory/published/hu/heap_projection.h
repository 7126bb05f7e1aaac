// The angle of repose of a heap from its projected area (Hu 2024, section 5.3).
#pragma once

#include "process/results/fill_result.h"

namespace diefill::process::laboratory {

/// m^2, area of all spheres above z = 0 projected as filled discs onto the xz plane (`axis` 0) or the yz
/// plane (1); holes count as filled. In pixels of a twentieth of the diameter.
double projected_area(const results::PowderState& powder, int axis);

/// deg, arctan(4 A / b^2) of a heap on a square plate of side `plate` (m), b = plate + d (Hu 2024, Eqs. 5.1
/// and 5.2); mean of both directions.
double area_equivalent_angle(const results::PowderState& powder, double plate);

/// Carr's class of an angle (deg): 0 below 30, then up to 38, 45, 55 and above: 4.
int carr_class(double angle);

}  // namespace diefill::process::laboratory
