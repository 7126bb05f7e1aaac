// What the nearest triangle costs: building the tree, questions about any places near the surface, and about
// places along it, each with a guess from the one before, as wall spheres are laid.
//   ninja nearest_triangle && bin/nearest_triangle [STL FILE in mm ...]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/cad/mesh_import.h"
#include "geometry/mesh/topology.h"
#include "geometry/mesh/triangle_tree.h"

namespace diefill::geometry {
namespace {

constexpr std::size_t kQuestions = 200000;

double seconds_of(const auto& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// Places within `reach` of the surface.
std::vector<Eigen::Vector3d> places_near(const Mesh& mesh, double reach) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::size_t> any(0, mesh.triangles.size() - 1);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Eigen::Vector3d> places(kQuestions);
  for (auto& place : places) {
    const Corners corners = corners_of(mesh, any(random));
    double u = part(random), v = part(random);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Eigen::Vector3d lateral(part(random) - 0.5, part(random) - 0.5, part(random) - 0.5);
    place = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]) + 2 * reach * lateral;
  }
  return places;
}

/// A walk along the surface in steps a hundredth of `reach`, as wall spheres are laid: what is asked about
/// one place is known well from the last.
std::vector<Eigen::Vector3d> places_along(const Mesh& mesh, double reach) {
  const auto ends = places_near(mesh, reach);
  constexpr std::size_t kSteps = 100;
  std::mt19937_64 random(2);
  std::normal_distribution<double> any(0, 1);
  std::vector<Eigen::Vector3d> places;
  for (std::size_t k = 0; places.size() < kQuestions; ++k) {
    const Eigen::Vector3d way = Eigen::Vector3d(any(random), any(random), any(random)).normalized();
    for (std::size_t step = 0; step < kSteps; ++step)
      places.push_back(ends[k] + 0.01 * reach * static_cast<double>(step) * way);
  }
  return places;
}

/// A torus of about `count` triangles, outer radius 20 mm.
Mesh torus(std::size_t count) {
  const auto n = static_cast<std::size_t>(std::sqrt(static_cast<double>(count) / 2));
  Mesh mesh;
  const auto vertex = [&](std::size_t i, std::size_t k) {
    return static_cast<std::uint32_t>((i % n) * n + k % n);
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const double a = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      const double b = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
      const double r = 15e-3 + 5e-3 * std::cos(b);
      mesh.vertices.emplace_back(r * std::cos(a), r * std::sin(a), 5e-3 * std::sin(b));
      mesh.triangles.emplace_back(vertex(i, k), vertex(i + 1, k), vertex(i + 1, k + 1));
      mesh.triangles.emplace_back(vertex(i, k), vertex(i + 1, k + 1), vertex(i, k + 1));
    }
  return mesh;
}

/// us a question, the least of five runs over all places.
double microseconds_of(const std::vector<Eigen::Vector3d>& places, const auto& ask) {
  double least = 1e9;
  for (int run = 0; run < 5; ++run)
    least = std::min(least, seconds_of([&] {
                       for (const auto& place : places) ask(place);
                     }));
  return 1e6 * least / static_cast<double>(places.size());
}

void measure(const std::string& name, const Mesh& mesh) {
  constexpr double kReach = 0.5e-3;  // m
  std::unique_ptr<TriangleTree> tree;
  const double build = seconds_of([&] {
    tree = std::make_unique<TriangleTree>(mesh.triangles.size(),
                                          [&](std::size_t t) { return corners_of(mesh, t); });
  });
  double sum = 0;  // so that no question is left out
  const double any = microseconds_of(
      places_near(mesh, kReach), [&](const auto& place) { sum += tree->nearest(place).distance_squared; });
  Eigen::Vector3d last = Eigen::Vector3d::Constant(1e9);
  double known = 0;
  const double along = microseconds_of(places_along(mesh, kReach), [&](const auto& place) {
    // The nearest triangle is no farther than it was from the last place and the way from there.
    const double guess = std::min(known + (place - last).norm(), 1.0);
    known = std::sqrt(tree->nearest(place, guess).distance_squared);
    last = place;
    sum += known;
  });
  std::printf("%s: %zu triangles; build %.3f s; a question %.2f us, along the surface %.2f us (%g)\n",
              name.c_str(), mesh.triangles.size(), build, any, along, sum);
}

}  // namespace
}  // namespace diefill::geometry

int main(int count, char** words) {
  using namespace diefill::geometry;
  for (int i = 1; i < count; ++i) measure(words[i], import_mesh(words[i], 1e-3));
  measure("torus", torus(20000));
  measure("torus", torus(2000000));
  return EXIT_SUCCESS;
}
