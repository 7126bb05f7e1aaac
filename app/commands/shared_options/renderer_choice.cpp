#include "app/commands/shared_options/renderer_choice.h"

#include <string>

#include "app/options/choices.h"
#include "render/scene3d/grain_view.h"

namespace diefill::app {

void add_renderer(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--renderer",
          [](const std::string& name) {
            render::set_renderer(name == "embree" ? render::Renderer::kEmbree : render::Renderer::kOpenGl);
          },
          "what draws shaded views: embree (ray tracer, soft shadow) or opengl (software OpenGL)")
      ->check(one_of({"embree", "opengl"}))
      ->default_str("opengl");
}

}  // namespace diefill::app
