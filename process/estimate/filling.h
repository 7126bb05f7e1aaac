// How full a cavity gets of what an opening would let through: inflow slows as the room above the powder
// shrinks.
#pragma once

namespace diefill::process::estimate {

/// The room below one opening. m.
struct Room {
  double depth = 0;  ///< volume over the mouth's area
  double width = 0;  ///< of the mouth, mean
};

/// Over the mouth's width: with less room than this above the powder, inflow slows. Fitted to the runs of
/// against_runs.csv (README.md, Error).
inline constexpr double kSlowsBelow = 1.5;

/// m of powder in the room once `offered` m have come to its mouth (mass over density and area), had it no
/// floor. Inflow is free while the room above the powder is higher than kSlowsBelow widths: what falls in
/// spreads below the mouth. Above that, the heap under the opening reaches into it, and only as much enters
/// as slides away: inflow is taken to fall in proportion to the room that is left (ours), so that dh/dq =
/// min(1, (H - h) / r) with r = min(H, kSlowsBelow D).
double filled_height(const Room& room, double offered);

/// The inverse: m to be offered until `height` m lie in the room. Infinite from the depth on.
double offered_for(const Room& room, double height);

}  // namespace diefill::process::estimate
