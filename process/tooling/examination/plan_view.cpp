#include "process/tooling/examination/plan_view.h"

#include <algorithm>

namespace diefill::process {

PlanView::PlanView(const geometry::Mesh& mesh, double z) {
  for (const auto& triangle : mesh.triangles) {
    std::vector<Eigen::Vector2d> ends;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d& a = mesh.vertices[static_cast<std::size_t>(triangle[i])];
      const Eigen::Vector3d& b = mesh.vertices[static_cast<std::size_t>(triangle[(i + 1) % 3])];
      if ((a.z() < z) == (b.z() < z)) continue;
      ends.emplace_back((a + (z - a.z()) / (b.z() - a.z()) * (b - a)).head<2>());
    }
    if (ends.size() == 2) segments_.push_back({ends[0], ends[1]});
  }
}

std::array<bool, 4> PlanView::walls_beside(const Eigen::Vector2d& place) const {
  std::array<bool, 4> walls = {};
  for (const Segment& segment : segments_)
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const Eigen::Index across = 1 - axis;
      const double a = segment.from[across], b = segment.to[across];
      if ((a < place[across]) == (b < place[across])) continue;
      const double at =
          segment.from[axis] + (place[across] - a) / (b - a) * (segment.to[axis] - segment.from[axis]);
      walls[static_cast<std::size_t>(2 * axis + (at > place[axis] ? 1 : 0))] = true;
    }
  return walls;
}

bool PlanView::solid(const Eigen::Vector2d& place) const {
  bool inside = false;
  for (const Segment& segment : segments_) {
    const double a = segment.from.y(), b = segment.to.y();
    if ((a < place.y()) == (b < place.y())) continue;
    const double at = segment.from.x() + (place.y() - a) / (b - a) * (segment.to.x() - segment.from.x());
    if (at > place.x()) inside = !inside;
  }
  return inside;
}

double PlanView::distance(const Eigen::Vector2d& place) const {
  double least = 1e300;
  for (const Segment& segment : segments_) {
    const Eigen::Vector2d along = segment.to - segment.from, off = place - segment.from;
    const double length = along.squaredNorm();
    const double part = length > 0 ? std::clamp(off.dot(along) / length, 0.0, 1.0) : 0;
    least = std::min(least, (off - part * along).norm());
  }
  return least;
}

bool PlanView::holds(const Eigen::Vector2d& place) const {
  const auto walls = walls_beside(place);
  return std::all_of(walls.begin(), walls.end(), [](bool wall) { return wall; }) && !solid(place);
}

Opening::Opening(const geometry::Mesh& mesh, double z) {
  const geometry::Box box = mesh.bounding_box();
  const PlanView view(mesh, z);
  origin_ = box.lower.head<2>();
  cell_ = (box.size().head<2>() / kCells).cwiseMax(1e-9);
  holds_.assign(static_cast<std::size_t>(kCells) * kCells, false);
  for (int j = 0; j < kCells; ++j)
    for (int i = 0; i < kCells; ++i) {
      // A little off the middles, which may lie on the corners of symmetric tools.
      const Eigen::Vector2d place = origin_ + cell_.cwiseProduct(Eigen::Vector2d(i + 0.4871, j + 0.5137));
      if (!view.holds(place)) continue;
      holds_[static_cast<std::size_t>(j) * kCells + static_cast<std::size_t>(i)] = true;
      lower_ = lower_.cwiseMin(place - 0.5 * cell_);
      upper_ = upper_.cwiseMax(place + 0.5 * cell_);
    }
}

bool Opening::contains(const Eigen::Vector2d& place) const {
  const Eigen::Array2d at = (place - origin_).array() / cell_.array();
  if ((at < 0).any() || (at >= kCells).any()) return false;
  return holds_[static_cast<std::size_t>(at.y()) * kCells + static_cast<std::size_t>(at.x())];
}

}  // namespace diefill::process
