// What the nearest triangle costs: geometry's tree against Embree's point query, building and asking, with
// the same exact distance in double precision. Embree's boxes are in single precision, so its search reaches
// a little farther than the nearest triangle found so far.
//   ninja nearest_triangle && bin/nearest_triangle [STL FILE in mm ...]
#include <embree3/rtcore.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/cad/mesh_import.h"
#include "geometry/mesh/triangle_tree.h"

namespace diefill::geometry {
namespace {

constexpr std::size_t kQuestions = 200000;
constexpr double kFarther = 1e-6;  // of the bounding box: rounding of corners to single precision

double seconds_of(const auto& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// Embree's hierarchy over the triangles of a mesh.
class EmbreeTree {
 public:
  explicit EmbreeTree(const Mesh& mesh) : mesh_(mesh), margin_(kFarther * mesh.bounding_box().size().norm()) {
    device_ = rtcNewDevice(nullptr);
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* places = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
    for (const auto& vertex : mesh.vertices)
      for (int k = 0; k < 3; ++k) *places++ = static_cast<float>(vertex[k]);
    auto* corners = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles)
      for (const auto corner : triangle) *corners++ = static_cast<unsigned>(corner);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~EmbreeTree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeTree(const EmbreeTree&) = delete;
  EmbreeTree& operator=(const EmbreeTree&) = delete;

  /// m^2, to the nearest triangle.
  double nearest(const Eigen::Vector3d& point) const {
    Search search{this, point, std::numeric_limits<double>::infinity()};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    alignas(16) RTCPointQuery query{static_cast<float>(point.x()), static_cast<float>(point.y()),
                                    static_cast<float>(point.z()), 0, std::numeric_limits<float>::infinity()};
    rtcPointQuery(scene_, &query, &context, look_at, &search);
    return search.distance_squared;
  }

 private:
  struct Search {
    const EmbreeTree* tree;
    Eigen::Vector3d point;
    double distance_squared;
  };
  static bool look_at(RTCPointQueryFunctionArguments* found) {
    auto& search = *static_cast<Search*>(found->userPtr);
    const Corners corners = corners_of(search.tree->mesh_, found->primID);
    const double distance = (closest_point(corners, search.point).point - search.point).squaredNorm();
    if (distance >= search.distance_squared) return false;
    search.distance_squared = distance;
    found->query->radius = static_cast<float>(std::sqrt(distance) + search.tree->margin_);
    return true;
  }

  const Mesh& mesh_;
  double margin_;  ///< m
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

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
    const Eigen::Vector3d aside(part(random) - 0.5, part(random) - 0.5, part(random) - 0.5);
    place = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]) + 2 * reach * aside;
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

void compare(const std::string& name, const Mesh& mesh) {
  const auto places = places_near(mesh, 0.5e-3);
  std::unique_ptr<TriangleTree> own;
  std::unique_ptr<EmbreeTree> embree;
  const double own_build = seconds_of([&] {
    own = std::make_unique<TriangleTree>(mesh.triangles.size(),
                                         [&](std::size_t t) { return corners_of(mesh, t); });
  });
  const double embree_build = seconds_of([&] { embree = std::make_unique<EmbreeTree>(mesh); });
  std::vector<double> by_own(places.size()), by_embree(places.size());
  double own_asks = 1e9, embree_asks = 1e9;
  for (int lap = 0; lap < 5; ++lap) {
    own_asks = std::min(own_asks, seconds_of([&] {
                          for (std::size_t i = 0; i < places.size(); ++i)
                            by_own[i] = own->nearest(places[i]).distance_squared;
                        }));
    embree_asks = std::min(embree_asks, seconds_of([&] {
                             for (std::size_t i = 0; i < places.size(); ++i)
                               by_embree[i] = embree->nearest(places[i]);
                           }));
  }
  std::size_t other = 0;
  for (std::size_t i = 0; i < places.size(); ++i) other += by_own[i] != by_embree[i];
  std::printf(
      "%-42s %9zu triangles; build %.3f, Embree %.3f s; a question %.2f, Embree %.2f us (%.2f times); other "
      "distances %zu of %zu\n",
      name.c_str(), mesh.triangles.size(), own_build, embree_build, 1e6 * own_asks / kQuestions,
      1e6 * embree_asks / kQuestions, embree_asks / own_asks, other, places.size());
}

}  // namespace
}  // namespace diefill::geometry

int main(int count, char** words) {
  using namespace diefill::geometry;
  for (int i = 1; i < count; ++i) compare(words[i], import_mesh(words[i], 1e-3));
  compare("torus", torus(20000));
  compare("torus", torus(2000000));
  return EXIT_SUCCESS;
}
