// Spheres sorted into cubic cells, for finding near pairs.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "engine/numerics/thread_pool.h"
#include "engine/powder/sphere_field.h"

namespace diefill::engine {

/// A sphere in a cell.
struct CellMember {
  std::uint32_t sphere;  ///< its number
  std::uint32_t owner;   ///< real grain that it belongs to, itself or as an image
};

/// How many cubic cells of which edge (m).
struct CellNumbers {
  Eigen::Vector3i cells;
  double edge;
};

/// Cells of edge at least `cell` (m) for `points` points in a box of these `extents` (m), lower faces
/// included: larger cells where there were more than eight a point (and some to start with), as a few far
/// grains must not cost a huge empty grid, or too many to number.
CellNumbers cells_for(const Eigen::Vector3d& extents, double cell, std::size_t points);

/// A grid of cells over spheres' centres, points (m) here. Points of a cell lie together, and cells along x
/// follow each other, so that a neighbourhood of 27 cells is nine runs.
class SphereCells {
 public:
  /// A member nearer than the limit, and the square of its distance, m^2.
  struct Near {
    CellMember member;
    double square;
  };

  /// Sorts the centres of all spheres into cells of edge at least `cell` (m). In a cell they follow each
  /// other by their numbers, whichever thread has put them there.
  void build(const SphereField& spheres, double cell, ThreadPool& pool);
  /// The same for some of them only, given by their numbers.
  void build(const SphereField& spheres, std::vector<std::uint32_t> members, double cell, ThreadPool& pool);

  /// A member that may be near.
  struct Candidate {
    std::uint32_t place;
    double square;  ///< m^2
  };

  /// Calls visit(Near) for every member nearer to `point` than `distance` (m), in a fixed order.
  /// `candidates`: room to work in, whatever it holds.
  template <class Visit>
  void visit_nearer(Vector3 point, double distance, std::vector<Candidate>& candidates,
                    const Visit& visit) const {
    std::size_t count = 0;
    for_runs(point, distance, [&](std::uint32_t begin, std::uint32_t end) {
      if (candidates.size() < count + (end - begin)) candidates.resize(2 * (count + (end - begin)));
      // Whether one is near cannot be predicted: all are written, and those too far are overwritten.
      Candidate* next = candidates.data() + count;
      for (std::uint32_t k = begin; k < end; ++k) {
        const Vector3 between = position_[k] - point;
        const double square = dot(between, between);
        *next = {k, square};
        next += square < distance * distance ? 1 : 0;
      }
      count = static_cast<std::size_t>(next - candidates.data());
    });
    for (std::size_t n = 0; n < count; ++n) visit(Near{member_[candidates[n].place], candidates[n].square});
  }

 private:
  /// Calls use(begin, end) for runs of places that hold all points in the cells that the cube of half edge
  /// `reach` (m) about `point` meets.
  template <class Use>
  void for_runs(Vector3 point, double reach, const Use& use) const {
    const Eigen::Array3d from = (eigen(point) - lower_).array() - reach, to = from + 2 * reach;
    // Clamped before they become integers: a point may be far outside the cells of others. Nothing is
    // negative then, and a cast rounds down; a cell too many does no harm.
    const Eigen::Array3d all = cells_.array().cast<double>();
    const Eigen::Array3i low = (from / edge_).max(0).min(all).cast<int>();
    const Eigen::Array3i high = (to / edge_ + 1).max(0).min(all).cast<int>() - 1;
    if ((low > high).any()) return;
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1]; ++y)
        use(first_[index_of(low[0], y, z)], first_[index_of(high[0], y, z) + 1]);
  }

  void choose_cells(const SphereField& spheres, double cell, ThreadPool& pool);
  void fill(const SphereField& spheres, ThreadPool& pool);
  template <class Use>
  void for_members_by_cell(ThreadPool& pool, const Use& use) const;

  std::size_t cells() const { return first_.size() - 1; }
  Eigen::Vector3i cell_of(Vector3 point) const { return ((eigen(point) - lower_) / edge_).cast<int>(); }
  std::size_t index_of(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(cells_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(cells_[0]) +
           static_cast<std::size_t>(x);
  }

  Eigen::Vector3d lower_ = Eigen::Vector3d::Zero();
  Eigen::Vector3i cells_ = Eigen::Vector3i::Ones();
  double edge_ = 1;
  std::vector<std::uint32_t> first_, cell_, members_;
  std::vector<CellMember> member_;
  std::vector<Vector3> position_;
};

}  // namespace diefill::engine
