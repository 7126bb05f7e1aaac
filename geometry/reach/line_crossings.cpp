#include "geometry/reach/line_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/grids/all_cores.h"
#include "geometry/mesh/topology.h"

namespace diefill::geometry {
namespace {

// Where the edge crosses the line v = `at`. Both triangles of an edge get the same number, because the ends
// are taken in an order that does not depend on the triangle.
std::optional<double> edge_crossing(Eigen::Vector2d one, Eigen::Vector2d other, double at) {
  if ((one.y() > at) == (other.y() > at)) return std::nullopt;
  if (one.y() > other.y()) std::swap(one, other);
  return one.x() + (other.x() - one.x()) * (at - one.y()) / (other.y() - one.y());
}

// Lines are counted half open (from <= centre < to), so that a line through an edge meets exactly one of its
// triangles.
class TriangleLines {
 public:
  TriangleLines(const VoxelGrid& grid, int axis, std::vector<Crossing>& crossings)
      : grid_(grid), axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3), crossings_(crossings) {}

  void add(const Corners& corners) {
    for (std::size_t i = 0; i < 3; ++i) flat_[i] = {corners[i][u_], corners[i][v_]};
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (normal[axis_] == 0) return;
    const auto [low, high] = std::minmax({flat_[0].y(), flat_[1].y(), flat_[2].y()});
    const int last = std::min(first_centre(v_, high), grid_.counts[v_]);
    for (int v = std::max(first_centre(v_, low), 0); v < last; ++v) add_line(corners, normal, v);
  }

 private:
  double centre(int axis, int voxel) const { return grid_.origin[axis] + (voxel + 0.5) * grid_.edge; }

  // The first voxel whose centre is not below `value`.
  int first_centre(int axis, double value) const {
    const double guess = std::ceil((value - grid_.origin[axis]) / grid_.edge - 0.5);
    int voxel = static_cast<int>(std::clamp(guess, -1.0, grid_.counts[axis] + 1.0)) - 1;
    while (voxel <= grid_.counts[axis] && centre(axis, voxel) < value) ++voxel;
    return voxel;
  }

  void add_line(const Corners& corners, const Eigen::Vector3d& normal, int v) {
    const double at = centre(v_, v);
    double from = 1e300, to = -1e300;
    for (std::size_t i = 0; i < 3; ++i) {
      if (const auto crossing = edge_crossing(flat_[i], flat_[(i + 1) % 3], at)) {
        from = std::min(from, *crossing);
        to = std::max(to, *crossing);
      }
    }
    if (from >= to) return;
    const auto [low, high] = std::minmax({corners[0][axis_], corners[1][axis_], corners[2][axis_]});
    const int last = std::min(first_centre(u_, to), grid_.counts[u_]);
    for (int u = std::max(first_centre(u_, from), 0); u < last; ++u) {
      const double rise = normal[u_] * (centre(u_, u) - corners[0][u_]) + normal[v_] * (at - corners[0][v_]);
      const double along = std::clamp(corners[0][axis_] - rise / normal[axis_], low, high);
      const auto row = static_cast<std::size_t>(v) * static_cast<std::size_t>(grid_.counts[u_]) +
                       static_cast<std::size_t>(u);
      crossings_.push_back({row, along, normal[axis_] < 0 ? 1 : -1});
    }
  }

  const VoxelGrid& grid_;
  int axis_, u_, v_;
  std::vector<Crossing>& crossings_;
  std::array<Eigen::Vector2d, 3> flat_;
};

// Crossings of all lines with all triangles, in the order of the triangles.
void find_crossings(const Mesh& mesh, const VoxelGrid& grid, int axis, std::vector<Crossing>& all) {
  constexpr std::size_t kOfAPart = 16384;  // triangles
  const auto find = [&](std::size_t part, std::vector<Crossing>& crossings) {
    TriangleLines lines(grid, axis, crossings);
    const std::size_t end = std::min(mesh.triangles.size(), (part + 1) * kOfAPart);
    for (std::size_t t = part * kOfAPart; t < end; ++t) lines.add(corners_of(mesh, t));
  };
  all.clear();
  std::vector<std::vector<Crossing>> parts(mesh.triangles.size() / kOfAPart + 1);
  if (parts.size() == 1) {
    find(0, all);
    return;
  }
  on_all_cores(parts.size(), [&](std::size_t part) { find(part, parts[part]); });
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
}

}  // namespace

// By line, then along the line. Entering comes first where shells touch, so that they become one stretch.
// Lines have few crossings each: counting them out by line is many times faster than comparing all.
void LineCrossings::sort(std::size_t lines) {
  ends_.assign(lines + 1, 0);
  for (const auto& crossing : crossings_) ++ends_[crossing.row + 1];
  for (std::size_t line = 0; line < lines; ++line) ends_[line + 1] += ends_[line];
  sorted_.resize(crossings_.size());
  for (const auto& crossing : crossings_) sorted_[ends_[crossing.row]++] = crossing;
  const auto before = [](const Crossing& one, const Crossing& other) {
    return one.along != other.along ? one.along < other.along : one.winding > other.winding;
  };
  for (auto begin = sorted_.begin(); begin != sorted_.end();) {
    const auto end = sorted_.begin() + static_cast<std::ptrdiff_t>(ends_[begin->row]);
    if (end - begin > 1) std::sort(begin, end, before);
    begin = end;
  }
  crossings_.swap(sorted_);
}

std::span<const Crossing> LineCrossings::find(const Mesh& mesh, const VoxelGrid& grid, int axis) {
  find_crossings(mesh, grid, axis, crossings_);
  sort(static_cast<std::size_t>(grid.counts[(axis + 1) % 3]) *
       static_cast<std::size_t>(grid.counts[(axis + 2) % 3]));
  return crossings_;
}

}  // namespace diefill::geometry
