// Whether what is poured fits between the tools.
#pragma once

#include <vector>

#include "engine/powder/new_grain.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// A poured grain's centre must be farther from every tool than this times its radius: its random offset may
/// bring it near a wall.
inline constexpr double kNearestTool = 0.9;

/// Throws SceneError where the pour box extends beside or below the standing tools (`standing`, m): powder
/// there would be lost at once.
void refuse_powder_over_nothing(const Scene& scene, const geometry::Box& standing);

/// Throws SceneError for a grain that starts in a tool, which would eject it. `radii`: m, of each type.
void refuse_overlap(const Scene& scene, const Tooling& tooling, const std::vector<engine::NewGrain>& grains,
                    const std::vector<double>& radii);

/// Throws SceneError where a tool closes the pour box from wall to wall below some of the grains: they would
/// lie on the lid. `layer`: m, largest distance of grains above each other.
void refuse_lid(const Scene& scene, const Tooling& tooling, const std::vector<engine::NewGrain>& grains,
                double layer);

/// Throws SceneError where the loose lattice reaches beyond a period along z. `radius`: m, of the largest
/// grain.
void refuse_beyond_period(const Scene& scene, const std::vector<engine::NewGrain>& grains, double radius);

}  // namespace diefill::process
