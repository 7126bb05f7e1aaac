// The three-dimensional view traced with Embree: the same scene, camera and colours as grain_view.h.
#pragma once

#include "render/scene3d/grain_view.h"

namespace diefill::render {

/// As draw_grains, whatever renderer `look` names. Throws std::runtime_error where Embree cannot be started.
QImage trace_grains(const results::FillResult& result, const std::vector<Rgb>& grain_colours,
                    const ViewChoice& view, int width, int height, const SceneLook& look);

}  // namespace diefill::render
