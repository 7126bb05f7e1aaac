// Times the shaded view of a filled box with both renderers in one run and writes both pictures:
// bin/view_times SPHERES FOLDER. Not a test.
#include <QImage>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "render/offscreen/start_offscreen.h"
#include "render/scene3d/snapshot.h"
#include "render/style/picture_file.h"

namespace diefill::render {
namespace {

constexpr double kEdge = 20e-3;  // m, of the box across; it is twice as high

/// A plate of 3 mm with the box's opening, as four walls.
results::ToolState wall(double x0, double x1, double y0, double y1) {
  results::ToolState tool{"die", "die", {}, {}, {}, 0, ""};
  for (const double z : {-2 * kEdge, 0.0})
    for (const auto& [x, y] : {std::pair(x0, y0), {x1, y0}, {x1, y1}, {x0, y1}})
      tool.vertices.emplace_back(x, y, z);
  tool.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                    {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  return tool;
}

/// Single spheres on a shaken lattice, solid fraction falling with height.
results::FillResult filled_box(std::size_t spheres) {
  results::FillResult result;
  result.strategy = "filled box";
  auto& powder = result.powder;
  const double spacing = std::cbrt(2 * kEdge * kEdge * kEdge / static_cast<double>(spheres));
  powder.grain_diameter = 0.98 * spacing;
  powder.sphere_radius = 0.49 * spacing;
  powder.sphere_offsets = {Eigen::Vector3d::Zero()};
  std::mt19937_64 random(1);
  std::normal_distribution<double> shake(0, 0.12 * spacing);
  const int across = static_cast<int>(kEdge / spacing);
  for (std::size_t n = 0; n < spheres; ++n) {
    const auto layer = static_cast<double>(n / static_cast<std::size_t>(across * across));
    const int place = static_cast<int>(n % static_cast<std::size_t>(across * across));
    Eigen::Vector3d centre(-0.5 * kEdge + (place % across + 0.5) * spacing,
                           -0.5 * kEdge + (place / across + 0.5) * spacing,
                           -2 * kEdge + (layer + 0.5) * spacing);
    for (double& coordinate : centre) coordinate += shake(random);
    powder.position.push_back(centre);
    powder.orientation.emplace_back(1, 0, 0, 0);
    result.solid_fraction.solid_fraction.push_back(0.36 - 2 * centre.z() + 0.1 * shake(random) / spacing);
    result.solid_fraction.open.push_back(0);
  }
  const double half = 0.5 * kEdge, outer = half + 6e-3;
  result.tools = {wall(-outer, -half, -outer, outer), wall(half, outer, -outer, outer),
                  wall(-half, half, half, outer)};
  result.cavity.lower_corner = {-half, -half, -2 * kEdge};
  result.cavity.upper_corner = {half, half, 0};
  return result;
}

int run(std::size_t spheres, const std::filesystem::path& folder) {
  const auto result = filled_box(spheres);
  for (const auto& [name, look] :
       {std::pair<const char*, SceneLook>{"embree", {Renderer::kEmbree, ToolLook::kCut, true, false}},
        {"opengl", {Renderer::kOpenGl, ToolLook::kCut, true, false}},
        {"opengl_ambient", {Renderer::kOpenGl, ToolLook::kCut, true, true}}}) {
    ViewOptions options;
    options.look = look;
    const auto begin = std::chrono::steady_clock::now();
    const auto picture = compose_snapshot(result, options);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    std::printf("%-16s %9zu spheres %7.2f s\n", name, spheres, time.count());
    std::fflush(stdout);
    write_png(folder / (std::string(name) + "_" + std::to_string(spheres) + ".png"), picture.image);
  }
  return 0;
}

}  // namespace
}  // namespace diefill::render

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "view_times SPHERES FOLDER\n");
    return 2;
  }
  diefill::render::start_offscreen(count, arguments);
  return diefill::render::run(std::strtoull(arguments[1], nullptr, 10), arguments[2]);
}
