// The three-dimensional view: grains as their spheres, tools cut open, drawn by VTK into an image without
// text.
#pragma once

#include <QImage>
#include <vector>

#include "process/results/fill_result.h"
#include "render/scene3d/view_choice.h"
#include "render/style/colour_map.h"

namespace diefill::render {

/// How tools are shown.
enum class ToolLook {
  kCut,          ///< cut open with the powder by the view's plane
  kTranslucent,  ///< whole, with the powder showing through
  kHidden
};

/// What a shaded view shows besides its framing.
struct SceneLook {
  ToolLook tools = ToolLook::kCut;
  bool cut_powder = true;          ///< grains before the view's plane are taken away
  bool ambient_occlusion = false;  ///< darkens gaps between grains
};

/// Draws the scene as `view` frames it, on white, width x height pixels, smoothed by twofold oversampling.
/// `grain_colours`: one a grain. Throws std::runtime_error when no software renderer is available.
QImage draw_grains(const results::FillResult& result, const std::vector<Rgb>& grain_colours,
                   const ViewChoice& view, int width, int height, const SceneLook& look = {});

}  // namespace diefill::render
