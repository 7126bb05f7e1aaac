// Fields of cavities of any shape: seen from above, seen from the side, and the height of the powder surface.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::process {

/// Which way a box map looks.
enum class BoxView {
  kPlan,  ///< from above: over x and y (mm, laboratory frame), mean over height
  kSide   ///< across the shoe's travel: over the travel's axis (x or y, mm) and height (mm above the floor)
};

/// Solid fraction over two coordinates of a cavity's box, mean along the third of Eq. 2.27 (Bierwisch 2009)
/// with Gaussian width `averaging_width` (m) over the places that hold powder and no tool, up to the fill
/// plane. Where none does: NaN, or what places_without_value.h says. Nodes are
/// `averaging_width` / 2 apart, or more for at most 120 along the longer side. Throws std::invalid_argument
/// for a cavity without size.
results::Field2D box_map(const results::FillResult& result, BoxView view, double averaging_width);

/// Height (mm above the cavity floor) of the powder surface over x and y (mm, laboratory frame): the top of
/// the highest sphere whose centre is within a grain diameter of the node, seen from above, NaN where there
/// is none, results::inside_tool() where a tool is at half the cavity's depth. Throws as box_map does.
results::Field2D fill_level_map(const results::FillResult& result);

/// Mean of fill_level_map across the shoe's travel, over the distance (mm) along it from the end of the
/// cavity's box where the shoe first arrives: of cavities that are no rings, what measure.h's fill_level is
/// of rings. Places without powder count as the floor; NaN where there is none across. Travel between x and y
/// counts as along the nearer. `level`: the map of the result whose cavity it is.
results::Profile fill_level_along_travel(const results::Field2D& level, const results::CavityState& cavity);
results::Profile fill_level_along_travel(const results::FillResult& result);

}  // namespace diefill::process
