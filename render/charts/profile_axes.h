// Axes and style of charts whose curves are profiles: fill level over azimuth and the like.
#pragma once

#include "process/results/fill_result.h"
#include "render/charts/chart.h"

namespace diefill::render {

/// Labels with units; a full turn with the shoe's sides marked where the profile runs over the azimuth.
void set_profile_axes(Chart& chart, const results::Profile& profile);

/// A line; with its points where there are few, so that none is read between them.
CurveStyle profile_style(const results::Profile& profile);

}  // namespace diefill::render
