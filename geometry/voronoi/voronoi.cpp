#include "geometry/voronoi/voronoi.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <voro++/voro++.hh>

#include "geometry/voronoi/neighbour_grid.h"

namespace diefill::geometry {
namespace {

// voro++ compares lengths with absolute tolerances near 1e-11, so all work is done in units of the (smallest)
// sphere radius.
constexpr double kSameCentre = 1e-9;
// Faces of the bounding polyhedron carry negative numbers; all true cuts share this one.
constexpr int kTrueFace = 1;
// Vertices of the 26-faced polyhedron below lie this much farther out than its faces.
constexpr double kVertexOverFace = 1.1281;

/// Normals of the twelve edges and eight corners of a cube: with its six faces they bound a nearly round
/// polyhedron.
std::vector<Eigen::Vector3d> edge_and_corner_normals() {
  std::vector<Eigen::Vector3d> normals;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (std::abs(x) + std::abs(y) + std::abs(z) >= 2)
          normals.push_back(Eigen::Vector3d(x, y, z).normalized());
  return normals;
}

/// The polyhedron every cell starts from; none of its points is farther than `reach` from the sphere's
/// centre.
void start_cell(voro::voronoicell_neighbor& cell, double reach) {
  const double face = reach / kVertexOverFace;
  cell.init(-face, face, -face, face, -face, face);
  int number = -7;  // voro++ numbers the cube's faces -1 to -6
  for (const auto& normal : edge_and_corner_normals())
    cell.nplane(normal.x(), normal.y(), normal.z(), 2 * face, number--);
}

/// A face that may cut a cell: voro++ keeps the points p with p . normal < twice_distance / 2.
struct Cut {
  double order;  ///< nearest first
  std::uint32_t index;
  Eigen::Vector3d normal;
  double twice_distance;
};

/// What one thread needs to build cells.
struct Workshop {
  explicit Workshop(double reach) { start_cell(start, reach); }
  Workshop(const Workshop&) = delete;
  voro::voronoicell_neighbor start, cell;
  std::vector<Cut> cuts;
  std::vector<int> faces;
};

struct SphereCell {
  double volume = 0;
  bool open = false;
};

double smallest_radius(const VoronoiRequest& request) {
  const auto& radii = request.sphere_radii;
  return radii.empty() ? request.sphere_radius : *std::min_element(radii.begin(), radii.end());
}

std::vector<std::uint32_t> grains_of(const VoronoiRequest& request) {
  if (!request.grains_of_spheres.empty()) return request.grains_of_spheres;
  std::vector<std::uint32_t> grains(request.sphere_centres.size());
  for (std::size_t s = 0; s < grains.size(); ++s)
    grains[s] = static_cast<std::uint32_t>(s / request.spheres_per_grain);
  return grains;
}

/// The first sphere of every grain, and the number of spheres at the end.
std::vector<std::size_t> first_spheres(const std::vector<std::uint32_t>& grains) {
  std::vector<std::size_t> first;
  for (std::size_t s = 0; s < grains.size(); ++s)
    if (s == 0 || grains[s] != grains[s - 1]) first.push_back(s);
  first.push_back(grains.size());
  return first;
}

/// Spheres and wall spheres in units of the smallest sphere's radius, ready for neighbour questions.
class Surroundings {
 public:
  explicit Surroundings(const VoronoiRequest& request)
      : unit_(smallest_radius(request)),
        grain_(grains_of(request)),
        reach_(request.largest_reach / unit_),
        radius_(scaled(request.sphere_radii)),
        largest_radius_(radius_.empty() ? 1 : *std::max_element(radius_.begin(), radius_.end())),
        wall_radius_(scaled(request.wall_radii)),
        largest_wall_radius_(
            wall_radius_.empty() ? 0 : *std::max_element(wall_radius_.begin(), wall_radius_.end())),
        spheres_(images(request.sphere_centres, request, cutting_distance(reach_, 1))),
        walls_(images(request.wall_centres, request, reach_ + largest_wall_radius_)),
        sphere_grid_(spheres_.points, 2.0),
        wall_grid_(walls_.points, std::max(1.0, largest_wall_radius_)) {}

  double reach() const { return reach_; }
  /// Cell of a sphere; its volume in m^3.
  SphereCell cell_of(std::uint32_t sphere, Workshop& workshop) const;

 private:
  std::vector<double> scaled(std::vector<double> lengths) const {
    for (double& length : lengths) length /= unit_;
    return lengths;
  }
  PointImages images(std::vector<Eigen::Vector3d> points, const VoronoiRequest& request,
                     double margin) const {
    auto period = request.period;
    for (auto& length : period)
      if (length) *length /= unit_;
    for (auto& point : points) point /= unit_;
    return with_periodic_images(points, period, margin);
  }

  /// How much more of the way to sphere `other` belongs to `sphere`: difference of squared radii.
  double power(std::uint32_t sphere, std::uint32_t other) const {
    return radius_.empty() ? 0 : radius_[sphere] * radius_[sphere] - radius_[other] * radius_[other];
  }
  /// Beyond it, no sphere cuts a cell of a sphere of `radius` whose vertices are within `farthest` of it.
  double cutting_distance(double farthest, double radius) const {
    return farthest + std::sqrt(farthest * farthest + (largest_radius_ * largest_radius_ - radius * radius));
  }

  enum class Twin { none, earlier_sphere_of_grain, other_grain };
  Twin twin_of(std::uint32_t sphere) const;
  bool cut_by_spheres(std::uint32_t sphere, Workshop& workshop) const;
  bool cut_by_walls(std::uint32_t sphere, Workshop& workshop) const;

  double unit_;
  std::vector<std::uint32_t> grain_;  ///< of every sphere
  double reach_;
  std::vector<double> radius_;  ///< of the spheres; empty: all are 1
  double largest_radius_;
  std::vector<double> wall_radius_;
  double largest_wall_radius_;
  PointImages spheres_, walls_;
  NeighbourGrid sphere_grid_, wall_grid_;
};

/// Cuts nearest first, so that far ones soon find nothing to cut. False when nothing of the cell remains.
bool apply_cuts(Workshop& workshop) {
  std::sort(workshop.cuts.begin(), workshop.cuts.end(), [](const Cut& a, const Cut& b) {
    return a.order != b.order ? a.order < b.order : a.index < b.index;
  });
  for (const Cut& cut : workshop.cuts) {
    const auto& n = cut.normal;
    if (!workshop.cell.nplane(n.x(), n.y(), n.z(), cut.twice_distance, kTrueFace)) return false;
  }
  return true;
}

/// Distance from the sphere's centre to the farthest vertex. voro++ stores vertices at twice their place.
double farthest_vertex(voro::voronoicell_neighbor& cell) {
  return 0.5 * std::sqrt(cell.max_radius_squared());
}

Surroundings::Twin Surroundings::twin_of(std::uint32_t sphere) const {
  Twin twin = Twin::none;
  const std::uint32_t grain = grain_[sphere];
  sphere_grid_.for_each_within(spheres_.points[sphere], kSameCentre,
                               [&](std::uint32_t n, const auto&, double) {
                                 const std::uint32_t other = spheres_.source[n];
                                 if (n == sphere) return;
                                 if (grain_[other] != grain)
                                   twin = Twin::other_grain;
                                 else if (other < sphere && twin == Twin::none)
                                   twin = Twin::earlier_sphere_of_grain;
                               });
  return twin;
}

bool Surroundings::cut_by_spheres(std::uint32_t sphere, Workshop& workshop) const {
  const double own_radius = radius_.empty() ? 1 : radius_[sphere];
  double searched = kSameCentre, radius = 4 * own_radius;
  for (;;) {
    workshop.cuts.clear();
    sphere_grid_.for_each_within(
        spheres_.points[sphere], radius, [&](std::uint32_t n, const Eigen::Vector3d& offset, double squared) {
          if (squared > searched * searched)
            workshop.cuts.push_back({squared, n, offset, squared + power(sphere, spheres_.source[n])});
        });
    if (!apply_cuts(workshop)) return false;
    // Of equal spheres, one farther than twice the farthest vertex is nearer to no point of the cell.
    const double needed = cutting_distance(farthest_vertex(workshop.cell), own_radius);
    if (radius >= needed) return true;
    searched = radius;
    radius = std::min(1.5 * radius, needed);
  }
}

bool Surroundings::cut_by_walls(std::uint32_t sphere, Workshop& workshop) const {
  const double farthest = farthest_vertex(workshop.cell);
  workshop.cuts.clear();
  wall_grid_.for_each_within(spheres_.points[sphere], farthest + largest_wall_radius_,
                             [&](std::uint32_t n, const Eigen::Vector3d& offset, double squared) {
                               const double distance = std::sqrt(squared);
                               const double to_surface = distance - wall_radius_[walls_.source[n]];
                               if (to_surface < farthest && distance > kSameCentre)
                                 workshop.cuts.push_back({to_surface, n, offset / distance, 2 * to_surface});
                             });
  return apply_cuts(workshop);
}

SphereCell Surroundings::cell_of(std::uint32_t sphere, Workshop& workshop) const {
  switch (twin_of(sphere)) {
    case Twin::earlier_sphere_of_grain:
      return {0, false};  // the earlier one has the whole cell
    case Twin::other_grain:
      return {0, true};
    case Twin::none:
      break;
  }
  workshop.cell = workshop.start;
  if (!cut_by_spheres(sphere, workshop) || !cut_by_walls(sphere, workshop)) return {0, true};
  workshop.cell.neighbors(workshop.faces);
  const bool limited =
      std::any_of(workshop.faces.begin(), workshop.faces.end(), [](int face) { return face < 0; });
  return {workshop.cell.volume() * unit_ * unit_ * unit_, limited};
}

void check(const VoronoiRequest& request) {
  if (!(request.sphere_radii.empty() ? request.sphere_radius > 0 : smallest_radius(request) > 0))
    throw std::invalid_argument("Voronoi cells need a positive sphere radius");
  if (!request.sphere_radii.empty() && request.sphere_radii.size() != request.sphere_centres.size())
    throw std::invalid_argument("Voronoi cells: every sphere needs one radius, or all have one together");
  if (!(request.largest_reach > 0))
    throw std::invalid_argument("Voronoi cells need a positive largest reach");
  const auto& grains = request.grains_of_spheres;
  if (!grains.empty()) {
    bool follow = grains.size() == request.sphere_centres.size() && grains.front() == 0;
    for (std::size_t s = 1; s < grains.size(); ++s)
      follow = follow && (grains[s] == grains[s - 1] || grains[s] == grains[s - 1] + 1);
    if (!follow)
      throw std::invalid_argument(
          "Voronoi cells: grains of spheres must be counted from 0, one after the other");
  } else if (request.spheres_per_grain == 0 ||
             request.sphere_centres.size() % request.spheres_per_grain != 0) {
    throw std::invalid_argument(
        "Voronoi cells: the number of spheres is no multiple of the spheres per grain");
  }
  if (request.wall_centres.size() != request.wall_radii.size())
    throw std::invalid_argument("Voronoi cells: every wall sphere needs one radius");
}

}  // namespace

VoronoiCells voronoi_cells(const VoronoiRequest& request) {
  constexpr std::size_t kGrainsAtOnce = 64;
  check(request);
  const Surroundings surroundings(request);
  const auto first = first_spheres(grains_of(request));
  const std::size_t grains = first.size() - 1;
  VoronoiCells cells{std::vector<double>(grains), std::vector<std::uint8_t>(grains)};
  tbb::enumerable_thread_specific<Workshop> workshops(surroundings.reach());
  // Tells the thread sanitizer the order that oneTBB guarantees: what is done before the loop is visible
  // inside it, and what is done inside is visible afterwards.
  std::atomic<std::size_t> begun{0}, ended{0};
  begun.fetch_add(1, std::memory_order_release);
  const auto measure = [&](const tbb::blocked_range<std::size_t>& range) {
    begun.load(std::memory_order_acquire);
    Workshop& workshop = workshops.local();
    for (std::size_t grain = range.begin(); grain < range.end(); ++grain) {
      for (std::size_t s = first[grain]; s < first[grain + 1]; ++s) {
        const SphereCell cell = surroundings.cell_of(static_cast<std::uint32_t>(s), workshop);
        cells.volume[grain] += cell.volume;
        if (cell.open) cells.open[grain] = 1;
      }
    }
    ended.fetch_add(1, std::memory_order_release);
  };
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, grains, kGrainsAtOnce), measure,
                    tbb::simple_partitioner());
  ended.load(std::memory_order_acquire);
  return cells;
}

}  // namespace diefill::geometry
