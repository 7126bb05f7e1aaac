// The opening that powder runs out of by itself, as from a hopper: scenes without a shoe.
#pragma once

#include <optional>

#include "process/estimate/discharge/inflow.h"
#include "process/estimate/estimate.h"

namespace diefill::process::estimate {

/// C of Beverloo's law for a round opening and C rho_a sqrt(g) (D - 1.4 d)^(5/2) (Beverloo, Leniger and van
/// de Velde 1961).
inline constexpr double kRoundOpening = 0.58;

/// The narrowest section below the middle of the box of [pour], between the tools as the steps leave them,
/// where powder gets on below it. Found where it is round, or a slit across x or y. Nothing in scenes with a
/// shoe. `scene` has prepared steps.
std::optional<OutletEstimate> outlet_of(const Scene& scene, const Tooling& tooling,
                                        const InflowPowder& powder, double mass);

}  // namespace diefill::process::estimate
