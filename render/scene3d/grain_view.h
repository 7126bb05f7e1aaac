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

/// What draws shaded views.
enum class Renderer {
  kEmbree,  ///< traces rays: soft shadow, ambient light, no OpenGL
  kOpenGl   ///< VTK through OSMesa
};

/// What draws where nothing else is said: OpenGL, until set_renderer. One for the program.
Renderer renderer();
void set_renderer(Renderer chosen);

/// What a shaded view shows besides its framing.
struct SceneLook {
  Renderer drawn_by = renderer();
  ToolLook tools = ToolLook::kCut;
  bool cut_powder = true;          ///< grains before the view's plane are taken away
  bool ambient_occlusion = false;  ///< OpenGL: darkens gaps between grains; Embree always does
};

/// Opacity of translucent tools.
inline constexpr double kTranslucency = 0.13;

/// Draws the scene as `view` frames it, on white, width x height pixels, smoothed by twofold oversampling,
/// with the renderer of `look`. `grain_colours`: one per grain. Throws std::runtime_error when the renderer
/// cannot be started.
QImage draw_grains(const results::FillResult& result, const std::vector<Rgb>& grain_colours,
                   const ViewChoice& view, int width, int height, const SceneLook& look = {});

}  // namespace diefill::render
