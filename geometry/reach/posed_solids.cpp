#include "geometry/reach/posed_solids.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace diefill::geometry {
namespace {

bool never_moves(const MovingSolid& solid) {
  const auto same = [&](std::size_t sample) {
    return solid.rotations[sample] == solid.rotations.front() &&
           solid.translations[sample] == solid.translations.front();
  };
  for (std::size_t sample = 1; sample < solid.translations.size(); ++sample) {
    if (!same(sample)) return false;
  }
  return true;
}

void check(const std::vector<MovingSolid>& solids) {
  for (const auto& solid : solids) {
    const auto samples = solids.front().translations.size();
    if (solid.mesh == nullptr || samples == 0 || solid.translations.size() != samples ||
        solid.rotations.size() != samples)
      throw std::invalid_argument(
          "reach: every solid needs a mesh and the same number of poses, at least one");
  }
}

// Lines that no moving solid crosses are as the standing solids left them.
std::vector<SolidRows::Row> joined_where_moving(const std::vector<const SolidRows*>& moving,
                                                const std::vector<const SolidRows*>& standing,
                                                double closing) {
  std::vector<std::size_t> lines;
  for (const auto* solid : moving) {
    for (const auto& row : solid->rows()) lines.push_back(row.row);
  }
  std::sort(lines.begin(), lines.end());
  std::vector<const SolidRows*> all = standing;
  all.insert(all.end(), moving.begin(), moving.end());
  auto joined = joined_rows(all, closing);
  std::erase_if(joined,
                [&](const auto& row) { return !std::binary_search(lines.begin(), lines.end(), row.row); });
  return joined;
}

double largest_step(const Box& box, const SolidPose& from, const SolidPose& to) {
  double largest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d point(corner & 1 ? box.lower.x() : box.upper.x(),
                                corner & 2 ? box.lower.y() : box.upper.y(),
                                corner & 4 ? box.lower.z() : box.upper.z());
    largest = std::max(largest, (to.to_laboratory(point) - from.to_laboratory(point)).norm());
  }
  return largest;
}

}  // namespace

PosedSolids::PosedSolids(const std::vector<MovingSolid>& solids, const VoxelGrid& grid)
    : solids_(solids), grid_(grid), standing_(3), standing_blocked_(grid.size(), 0) {
  check(solids);
  if (!solids.empty()) samples_ = solids.front().translations.size();
  for (std::size_t i = 0; i < solids.size(); ++i) {
    stands_.push_back(never_moves(solids[i]));
    if (!stands_.back()) continue;
    auto rows = rows_of(i, pose(i, 0));
    for (std::size_t axis = 0; axis < 3; ++axis) standing_[axis].push_back(std::move(rows[axis]));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<const SolidRows*> standing;
    for (const auto& rows : standing_[axis]) standing.push_back(&rows);
    block(grid, static_cast<int>(axis), joined_rows(standing, grid.edge), standing_blocked_);
  }
}

SolidPose PosedSolids::pose(std::size_t solid, std::size_t sample) const {
  return {solids_[solid].rotations[sample], solids_[solid].translations[sample]};
}

std::vector<SolidRows> PosedSolids::rows_of(std::size_t solid, const SolidPose& pose) {
  const Mesh mesh = transformed(*solids_[solid].mesh, pose.rotation, pose.translation);
  std::vector<SolidRows> rows;
  for (int axis = 0; axis < 3; ++axis) rows.emplace_back(mesh, grid_, axis, crossings_);
  return rows;
}

std::vector<SolidPose> PosedSolids::poses_to_next(std::size_t solid, std::size_t sample) const {
  const SolidPose from = pose(solid, sample), to = pose(solid, sample + 1);
  const double step = largest_step(solids_[solid].mesh->bounding_box(), from, to);
  const int steps = static_cast<int>(std::ceil(step / grid_.edge));
  const Eigen::Quaterniond begin(from.rotation), end(to.rotation);
  std::vector<SolidPose> way = {from};
  for (int i = 1; i < steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    way.push_back({begin.slerp(part, end).toRotationMatrix(),
                   from.translation + part * (to.translation - from.translation)});
  }
  if (steps > 0) way.push_back(to);
  return way;
}

std::vector<std::uint8_t> PosedSolids::blocked(std::size_t sample) {
  std::vector<std::vector<SolidRows>> moving;
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    if (!stands_[i]) moving.push_back(rows_of(i, pose(i, sample)));
  }
  auto result = standing_blocked_;
  if (moving.empty()) return result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<const SolidRows*> moved, standing;
    for (const auto& rows : moving) moved.push_back(&rows[axis]);
    for (const auto& rows : standing_[axis]) standing.push_back(&rows);
    block(grid_, static_cast<int>(axis), joined_where_moving(moved, standing, grid_.edge), result);
  }
  return result;
}

PosedSolids::Part PosedSolids::blocked_by(std::size_t solid, const SolidPose& pose) {
  const Mesh mesh = transformed(*solids_[solid].mesh, pose.rotation, pose.translation);
  const Box box = mesh.bounding_box();
  Part part;
  part.first = grid_.voxel_at(box.lower).cwiseMax(0);
  const Eigen::Vector3i last = grid_.voxel_at(box.upper).cwiseMin(grid_.counts - Eigen::Vector3i::Ones());
  part.grid = {grid_.origin + part.first.cast<double>() * grid_.edge, grid_.edge,
               (last - part.first + Eigen::Vector3i::Ones()).cwiseMax(0)};
  part.blocked.assign(part.grid.size(), 0);
  if (part.blocked.empty()) return part;  // still or again outside the grid, as on a long way to it
  for (int axis = 0; axis < 3; ++axis)
    block(part.grid, axis, SolidRows(mesh, part.grid, axis, crossings_).rows(), part.blocked);
  return part;
}

}  // namespace diefill::geometry
