// Where tools leave room at one height, seen from above.
#pragma once

#include <utility>
#include <vector>

#include "geometry/solid/slice_outline.h"

namespace diefill::process::estimate {

/// The outlines of all tools at one height, m.
class Outline {
 public:
  /// Adds what the plane at `height` cuts out of a closed mesh.
  void add(const geometry::Mesh& mesh, double height);

  bool empty() const { return pieces_.empty(); }
  std::size_t size() const { return pieces_.size(); }
  /// Stretches [from, to] of x between two tools, or two walls of one, on the line y (m), rising.
  std::vector<std::pair<double, double>> gaps(double y) const;
  /// m, from `place` to the nearest wall.
  double distance(const Eigen::Vector2d& place) const;
  /// m, of the straight line through `place` along the unit vector `direction`, from wall to wall.
  double chord(const Eigen::Vector2d& place, const Eigen::Vector2d& direction) const;

 private:
  struct Piece {
    Eigen::Vector2d from, to;
    std::size_t tool;
  };
  std::vector<Piece> pieces_;
  std::size_t tools_ = 0;
};

}  // namespace diefill::process::estimate
