// A run of about a hundred grains above a plate, without files of tools.
#pragma once

#include <memory>
#include <string>

#include "process/run/fill_run.h"
#include "tests/process/box_tools.h"

namespace diefill::process {

/// A plate of 20 x 20 mm, its top at z = 0.
inline geometry::Mesh plate_of_20_mm() {
  geometry::Mesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.emplace_back((k & 1) != 0 ? 0.01 : -0.01, (k & 2) != 0 ? 0.01 : -0.01,
                               (k & 4) != 0 ? 0 : -0.002);
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// About a hundred grains that fall on the plate; `other` are tables beside [powder].
class OnAPlate {
 public:
  explicit OnAPlate(const std::string& powder, const std::string& other = "",
                    const std::string& steps = "[[step]]\nkind = \"wait\"\nduration = \"1 s\"\n",
                    const std::string& numerics = "") {
    support::SceneTables tables;
    tables.numerics += numerics;
    tables.powder = powder + "\n" + other;
    tables.pour =
        "from = [\"-1 mm\", \"-1 mm\", \"0 mm\"]\nto = [\"1 mm\", \"1 mm\", \"5 mm\"]\n"
        "fill_height = \"1.5 mm\"\n";
    tables.steps = steps;
    scene = read_scene(folder_.write(support::scene_text(tables)));
    tooling.tools.resize(1);
    tooling.tools[0].spec = scene.tools[0];
    tooling.tools[0].mesh = plate_of_20_mm();
    tooling.tools[0].wall_mesh = plate_of_20_mm();
    tooling.all = tooling.standing = tooling.tools[0].mesh.bounding_box();
    tooling.standing.include(Eigen::Vector3d(0, 0, 0.05));
  }

  /// Runs until `max_time` (s), from the checkpoint in the folder if there is one.
  std::unique_ptr<FillRun> run_until(double max_time) {
    scene.numerics.max_time = max_time;
    RunOptions options;
    options.directory = folder_.path();
    options.show_progress = false;
    options.threads = 1;
    options.resume = true;
    auto run = std::make_unique<FillRun>(scene, tooling, options);
    run->run();
    return run;
  }

  Scene scene;
  Tooling tooling;

 private:
  SceneFolder folder_;
};

}  // namespace diefill::process
