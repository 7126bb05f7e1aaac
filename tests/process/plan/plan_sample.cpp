#include "tests/process/plan/plan_sample.h"

namespace diefill::process::plan {

geometry::Mesh box_mesh(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  geometry::Mesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.emplace_back(k & 1 ? upper[0] : lower[0], k & 2 ? upper[1] : lower[1],
                               k & 4 ? upper[2] : lower[2]);
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

support::SceneTables PlannedScene::waiting() {
  support::SceneTables tables;
  tables.steps = "[[step]]\nkind = \"wait\"\nduration = \"0.3 s\"\n";
  return tables;
}

PlannedScene::PlannedScene(support::SceneTables tables)
    : scene(read_scene(folder.write(support::scene_text(tables)))) {
  tooling.tools.resize(2);
  for (std::size_t k = 0; k < 2; ++k) {
    tooling.tools[k].spec = scene.tools[k];
    tooling.tools[k].mesh = box_mesh({-0.05, -0.02, -0.03}, {0.05, 0.02, 0});
    tooling.tools[k].spheres.centres.assign(100 * (k + 1), Eigen::Vector3d::Zero());
  }
  tooling.cavity.found = true;
  tooling.cavity.narrowest_width = kWidth;
  tooling.cavity.volume = 5e-6;
  tooling.cavity.box.include(Eigen::Vector3d(-0.01, -0.01, -0.02));
  tooling.cavity.box.include(Eigen::Vector3d(0.01, 0.01, 0));
}

Plan sample_plan(const PlannedScene& planned) {
  Plan plan;
  plan.scene = planned.scene;
  plan.tooling = planned.tooling;
  plan.pilot.emplace();
  const double costs[] = {10e-9, 40e-9, 20e-9};
  for (std::size_t k = 0; k < 3; ++k) {
    plan.pilot->cost[k].sphere_steps = 1e6;
    plan.pilot->cost[k].wall_seconds = 1e6 * costs[k];
  }
  add_choices(plan);
  return plan;
}

}  // namespace diefill::process::plan
