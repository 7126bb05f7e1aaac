// Closes what the regular grids leave open, and measures how well the spheres follow the surface.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/mesh/surface_facets.h"
#include "geometry/solid/surface_stretches.h"
#include "geometry/wall_spheres/wall_layout.h"
#include "geometry/wall_spheres/wall_spheres.h"

namespace diefill::geometry {

/// The surface to cover, seen through its facets.
struct CoverTarget {
  const Mesh& mesh;
  const Facets& facets;
  /// Empty: everything is reachable. Called by several threads at once.
  const std::function<bool(const Eigen::Vector3d&, const Eigen::Vector3d&)>& reachable;
  std::vector<Stretch> stretches;  ///< of the facets
  PointGrid near_powder;           ///< reachable_points(): reachability is computed once
  PointGrid powder_parts;          ///< a few of them, to pass over large surfaces far from powder quickly
  const std::function<void(double)>& on_progress;  ///< receives the finished share; may be empty
};

/// Reports progress while stretches are processed: of a part of all work that takes the share from `from` to
/// `to`.
class StretchProgress {
 public:
  StretchProgress(const CoverTarget& target, double from, double to)
      : target_(target), from_(from), to_(to) {}
  void next() {
    ++done_;
    if (target_.on_progress)
      target_.on_progress(from_ + (to_ - from_) * static_cast<double>(done_) /
                                      static_cast<double>(target_.stretches.size()));
  }

 private:
  const CoverTarget& target_;
  double from_, to_;
  std::size_t done_ = 0;
};

/// Shares of the time that a surface of ten million triangles takes, as sampled, when they begin.
inline constexpr double kHolesBegin = 0.24, kRepeatPassesBegin = 0.71, kMeasuringBegins = 0.76;

/// Points of the reachable surface about `step` (m) apart. Reachable patches narrower than that may be
/// missed.
PointGrid reachable_points(const CoverTarget& target, double step);

/// A subset of the `reachable` points such that each of them is near one of it, for spheres of `radius` (m).
PointGrid powder_parts(const PointGrid& reachable, double radius);

/// What is already known about a sample of the surface.
enum class SampleKnown : std::uint8_t {
  kBeyond,        ///< where powder comes
  kReachable,     ///< and nothing more is known
  kCovered,       ///< no hole can be there, as centres only come
  kStraightBelow  ///< its place at depth R is straight below
};
/// By stretch, in the order of its samples.
using SamplesKnown = std::vector<std::vector<SampleKnown>>;

/// Adds centres until every reachable point of the surface, moved to depth R, has one within half the
/// diagonal of the grid's squares. Each new centre goes on growing a square lattice over the open surface
/// around it. Throws MeshError where the solid is too thin to hold a sphere.
SamplesKnown close_cover(const CoverTarget& target, WallLayout& layout);

/// Fills in the deviations and the largest gap of `spheres` (see wall_spheres.h for what they mean).
void measure_cover(const CoverTarget& target, const WallLayout& layout, SamplesKnown& known,
                   WallSpheres& spheres);

}  // namespace diefill::geometry
