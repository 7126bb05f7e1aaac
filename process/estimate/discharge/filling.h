// How full a cavity gets of what an opening would let through: inflow slows as the space above the powder
// shrinks.
#pragma once

namespace diefill::process::estimate {

/// The space below one opening. m.
struct FillSpace {
  double depth = 0;  ///< volume over the area of the opening
  double width = 0;  ///< of the opening, mean
};

/// Over the width of the opening: with less space than this above the powder, inflow slows. Fitted to the
/// runs of against_runs.csv (README.md, Error).
inline constexpr double kSlowsBelow = 1.5;

/// m of powder in the space once `offered` m have come to its opening (mass over density and area), had it no
/// floor. Inflow is free while the space above the powder is higher than kSlowsBelow widths: what falls in
/// spreads below the opening. Above that, the heap under the opening reaches into it, and only as much enters
/// as slides away: inflow is taken to fall in proportion to the space that is left (ours), so that dh/dq =
/// min(1, (H - h) / r) with r = min(H, kSlowsBelow D).
double filled_height(const FillSpace& space, double offered);

/// The inverse: m to be offered until `height` m lie in the space. Infinite from the depth on.
double offered_for(const FillSpace& space, double height);

}  // namespace diefill::process::estimate
