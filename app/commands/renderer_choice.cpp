#include "app/commands/renderer_choice.h"

#include <string>

#include "render/scene3d/grain_view.h"

namespace diefill::app {

void add_renderer(CLI::App& command) {
  command
      .add_option_function<std::string>(
          "--renderer",
          [](const std::string& name) {
            render::set_renderer(name == "opengl" ? render::Renderer::kOpenGl : render::Renderer::kEmbree);
          },
          "what draws shaded views: embree (ray tracer, soft shadow) or opengl (software OpenGL)")
      ->check(CLI::IsMember({"embree", "opengl"}))
      ->default_str("embree");
}

}  // namespace diefill::app
