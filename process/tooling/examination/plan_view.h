// A tool seen from above at one height: where its walls are, and which places they enclose.
#pragma once

#include <array>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::process {

/// The section of a mesh at one height.
class PlanView {
 public:
  /// `z`: m, in the mesh's frame.
  PlanView(const geometry::Mesh& mesh, double z);

  bool empty() const { return segments_.empty(); }
  /// Whether walls stand in the directions -x, +x, -y and +y of a place (m).
  std::array<bool, 4> walls_beside(const Eigen::Vector2d& place) const;
  /// Whether the place is inside the solid.
  bool solid(const Eigen::Vector2d& place) const;
  /// m, from the place to the nearest wall; 1e300 where there is none.
  double distance(const Eigen::Vector2d& place) const;
  /// Whether walls stand on all four sides of a place outside the solid.
  bool holds(const Eigen::Vector2d& place) const;

 private:
  struct Segment {
    Eigen::Vector2d from, to;
  };
  std::vector<Segment> segments_;
};

/// The places that a tool encloses at a height, as a raster: computed once, queried often.
class Opening {
 public:
  Opening(const geometry::Mesh& mesh, double z);

  bool empty() const { return lower_.x() > upper_.x(); }
  bool contains(const Eigen::Vector2d& place) const;
  const Eigen::Vector2d& lower() const { return lower_; }  ///< m
  const Eigen::Vector2d& upper() const { return upper_; }  ///< m
  Eigen::Vector2d size() const { return upper_ - lower_; }

 private:
  static constexpr int kCells = 120;  // each way
  Eigen::Vector2d origin_, cell_;
  std::vector<bool> holds_;
  Eigen::Vector2d lower_ = Eigen::Vector2d::Constant(1e300), upper_ = Eigen::Vector2d::Constant(-1e300);
};

}  // namespace diefill::process
