// The three-dimensional view: grains as their spheres, tools cut open, drawn by VTK into an image without
// text.
#pragma once

#include <QImage>
#include <vector>

#include "process/results/fill_result.h"
#include "render/colour_map.h"
#include "render/view_choice.h"

namespace diefill::render {

/// Draws the scene as `view` frames it, on white, width x height pixels, smoothed by twofold oversampling.
/// `grain_colours`: one a grain. Throws std::runtime_error when no software renderer is available.
QImage draw_grains(const results::FillResult& result, const std::vector<Rgb>& grain_colours,
                   const ViewChoice& view, int width, int height);

}  // namespace diefill::render
