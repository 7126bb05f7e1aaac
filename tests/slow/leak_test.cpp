// Fast grains from all sides pass no wall of the sample tools; through a wall made coarse on purpose they
// pass where the gap statistic says so.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <random>

#include "engine/simulation/simulation.h"
#include "geometry/cad/mesh_import.h"
#include "geometry/solid/solid_query.h"
#include "geometry/wall_spheres/wall_spheres.h"
#include "project_paths.h"
#include "tests/support/contact_access.h"

namespace diefill::process {
namespace {

constexpr double kSpeed = 3;  // m/s, three times what a fall of 45 mm gives
constexpr double kGrainRadius = 1.5e-4;
constexpr double kGrainMass = 7.63e-8;  // kg
constexpr double kStart = 1e-3;         // m, from the surface that a grain is aimed at
constexpr double kFlight = 2e-3;        // s
constexpr int kLooks = 40;              // in that time: a grain moves 0.15 mm between two
constexpr double kStep = 5e-7;          // s
constexpr std::size_t kGrains = 3000;

engine::SimulationSettings settings() {
  engine::SimulationSettings settings;
  settings.types = {{engine::model_a(kGrainRadius, kGrainMass)}};
  engine::grain_contact(settings) = {1e7, 1e6 * kGrainRadius, 1e6 * kGrainRadius, 0.25, 0, 0};
  engine::wall_contact(settings) = engine::grain_contact(settings);
  settings.gravity.setZero();
  settings.time_step = kStep;
  settings.threads = 2;
  return settings;
}

/// Grains aimed at places spread over the surface by area, from up to 60 degrees off its normal, where the
/// way there is free.
std::vector<engine::NewGrain> volley(const geometry::Mesh& mesh, const geometry::SolidQuery& solid) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> area;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](int k) { return mesh.vertices[static_cast<std::size_t>(t[k])]; };
    area.push_back((at(1) - at(0)).cross(at(2) - at(0)).norm() + (area.empty() ? 0 : area.back()));
  }
  std::vector<engine::NewGrain> grains;
  for (std::size_t tries = 0; grains.size() < kGrains && tries < 40 * kGrains; ++tries) {
    const auto chosen = std::lower_bound(area.begin(), area.end(), unit(random) * area.back()) - area.begin();
    const auto& t = mesh.triangles[static_cast<std::size_t>(chosen)];
    const auto at = [&](int k) { return mesh.vertices[static_cast<std::size_t>(t[k])]; };
    double u = unit(random), v = unit(random);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Eigen::Vector3d aim = at(0) + u * (at(1) - at(0)) + v * (at(2) - at(0));
    const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    Eigen::Vector3d from(2 * unit(random) - 1, 2 * unit(random) - 1, 2 * unit(random) - 1);
    if (from.norm() > 1 || from.norm() < 0.1 || from.normalized().dot(normal) < 0.5) continue;
    engine::NewGrain grain;
    grain.position = aim + kStart * from.normalized();
    grain.velocity = -kSpeed * from.normalized();
    const double clear = 1.05 * kGrainRadius;
    bool free = true;
    for (double part = 0.2; part <= 1; part += 0.2)
      free = free && solid.signed_distance(aim + part * kStart * from.normalized()) > part * clear;
    const auto crowded = [&](const engine::NewGrain& other) {
      return (other.position - grain.position).norm() < 2.2 * kGrainRadius;
    };
    if (free && solid.signed_distance(grain.position) > clear &&
        std::none_of(grains.begin(), grains.end(), crowded))
      grains.push_back(grain);
  }
  return grains;
}

/// Grains whose centre is inside the solid behind the wall spheres at any look.
std::size_t leaked(const geometry::Mesh& mesh, const geometry::WallSpheres& spheres) {
  const geometry::SolidQuery solid(mesh);
  engine::WallBodySpec tool;
  tool.centres = spheres.centres;
  tool.sphere_radius = spheres.radius;
  engine::Simulation simulation(settings(), {tool});
  simulation.add_grains(volley(mesh, solid));
  std::vector<std::uint64_t> lost;
  const int steps = static_cast<int>(kFlight / kStep / kLooks);
  for (int look = 0; look < kLooks; ++look) {
    for (int step = 0; step < steps; ++step) simulation.step();
    const auto& grains = simulation.grains();
    for (std::size_t k = 0; k < grains.size(); ++k)
      if (solid.signed_distance(grains.position[k]) < -spheres.radius) lost.push_back(grains.id[k]);
  }
  std::sort(lost.begin(), lost.end());
  return static_cast<std::size_t>(std::unique(lost.begin(), lost.end()) - lost.begin());
}

std::vector<std::filesystem::path> shipped_tools() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(DIEFILL_SOURCE_DIR "/sample_tools"))
    if (entry.path().extension() == ".stl") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Leaks, NoFastGrainPassesAShippedTool) {
  for (const auto& file : shipped_tools()) {
    const geometry::Mesh mesh = geometry::import_mesh(file, 1e-3);
    geometry::WallSphereOptions options;
    const geometry::WallSpheres spheres = geometry::make_wall_spheres(mesh, options);
    EXPECT_LT(spheres.largest_gap, 2 * kGrainRadius) << file;
    const std::size_t lost = leaked(mesh, spheres);
    std::printf("%s: %zu wall spheres, gap %.3g mm, %zu lost\n", file.filename().c_str(),
                spheres.centres.size(), 1e3 * spheres.largest_gap, lost);
    EXPECT_EQ(lost, 0U) << file;
  }
}

TEST(Leaks, ArePredictedByTheGapOfACoarseWall) {
  const geometry::Mesh mesh =
      geometry::import_mesh(DIEFILL_SOURCE_DIR "/sample_tools/gear/core_rods.stl", 1e-3);
  geometry::WallSphereOptions options;
  options.spacing = 6;
  const geometry::WallSpheres spheres = geometry::make_wall_spheres(mesh, options);
  EXPECT_GT(spheres.largest_gap, 2 * kGrainRadius);
  const std::size_t lost = leaked(mesh, spheres);
  std::printf("coarse wall: gap %.3g mm, %zu lost\n", 1e3 * spheres.largest_gap, lost);
  EXPECT_GT(lost, 0U);
}

}  // namespace
}  // namespace diefill::process
