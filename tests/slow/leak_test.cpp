// Fast grains from all sides pass no wall of the sample tools; through a wall made coarse on purpose they
// pass where the gap statistic says so.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <random>

#include "engine/simulation/simulation.h"
#include "geometry/cad/mesh_import.h"
#include "geometry/solid/solid_query.h"
#include "geometry/wall_spheres/wall_spheres.h"
#include "project_paths.h"
#include "tests/support/contact_access.h"

namespace diefill::process {
namespace {

constexpr double kSpeed = 3;       // m/s, three times what a fall of 45 mm gives
constexpr double kDensity = 5400;  // kg/m^3
constexpr double kStart = 6.7;     // grain radii from the surface that a grain is aimed at
constexpr double kFlight = 2e-3;   // s
constexpr int kLooks = 40;         // in that time: a grain moves 0.15 mm between two
constexpr double kStep = 5e-7;     // s
constexpr std::size_t kGrains = 3000;
constexpr double kMostSpheres = 1e6;  // of a wall

engine::SimulationSettings settings(double radius) {
  engine::SimulationSettings settings;
  settings.types = {
      {engine::model_a(radius, kDensity * 4 / 3 * std::numbers::pi * radius * radius * radius)}};
  engine::grain_contact(settings) = {1e7, 1e6 * radius, 1e6 * radius, 0.25, 0, 0};
  engine::wall_contact(settings) = engine::grain_contact(settings);
  settings.gravity.setZero();
  settings.time_step = kStep;
  settings.threads = 2;
  return settings;
}

/// m^2, of the triangles up to each.
std::vector<double> area_up_to(const geometry::Mesh& mesh) {
  std::vector<double> area;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](int k) { return mesh.vertices[static_cast<std::size_t>(t[k])]; };
    area.push_back((at(1) - at(0)).cross(at(2) - at(0)).norm() / 2 + (area.empty() ? 0 : area.back()));
  }
  return area;
}

/// m: the default, or for tools of half a metre as much more as leaves a million spheres.
double wall_radius(const geometry::Mesh& mesh) {
  const geometry::WallSphereOptions usual;
  return std::max(usual.radius, std::sqrt(area_up_to(mesh).back() / kMostSpheres) / usual.spacing);
}

/// Grains of `radius` (m) aimed at places spread over the surface by area, from up to 60 degrees off its
/// normal, where the way there is free.
std::vector<engine::NewGrain> volley(const geometry::Mesh& mesh, const geometry::SolidQuery& solid,
                                     double radius) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const std::vector<double> area = area_up_to(mesh);
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
    const double start = kStart * radius;
    grain.position = aim + start * from.normalized();
    grain.velocity = -kSpeed * from.normalized();
    const double clear = 1.05 * radius;
    bool free = true;
    for (double part = 0.2; part <= 1; part += 0.2)
      free = free && solid.signed_distance(aim + part * start * from.normalized()) > part * clear;
    const auto crowded = [&](const engine::NewGrain& other) {
      return (other.position - grain.position).norm() < 2.2 * radius;
    };
    if (free && solid.signed_distance(grain.position) > clear &&
        std::none_of(grains.begin(), grains.end(), crowded))
      grains.push_back(grain);
  }
  return grains;
}

/// Grains of the wall spheres' size whose centre is inside the solid behind them at any look.
std::size_t leaked(const geometry::Mesh& mesh, const geometry::WallSpheres& spheres) {
  const geometry::SolidQuery solid(mesh);
  engine::WallBodySpec tool;
  tool.centres = spheres.centres;
  tool.sphere_radius = spheres.radius;
  engine::Simulation simulation(settings(spheres.radius), {tool});
  simulation.add_grains(volley(mesh, solid, spheres.radius));
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
    options.radius = wall_radius(mesh);
    const geometry::WallSpheres spheres = geometry::make_wall_spheres(mesh, options);
    EXPECT_LT(spheres.largest_gap, 2 * spheres.radius) << file;
    const std::size_t lost = leaked(mesh, spheres);
    std::printf("%s: %zu wall spheres of %.3g mm, gap %.3g mm, %zu lost\n", file.filename().c_str(),
                spheres.centres.size(), 1e3 * spheres.radius, 1e3 * spheres.largest_gap, lost);
    std::fflush(stdout);
    EXPECT_EQ(lost, 0U) << file;
  }
}

TEST(Leaks, ArePredictedByTheGapOfACoarseWall) {
  const geometry::Mesh mesh =
      geometry::import_mesh(DIEFILL_SOURCE_DIR "/sample_tools/gear/core_rods.stl", 1e-3);
  geometry::WallSphereOptions options;
  options.spacing = 6;
  const geometry::WallSpheres spheres = geometry::make_wall_spheres(mesh, options);
  EXPECT_GT(spheres.largest_gap, 2 * spheres.radius);
  const std::size_t lost = leaked(mesh, spheres);
  std::printf("coarse wall: gap %.3g mm, %zu lost\n", 1e3 * spheres.largest_gap, lost);
  EXPECT_GT(lost, 0U);
}

}  // namespace
}  // namespace diefill::process
