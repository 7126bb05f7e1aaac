#include "geometry/reach/reach.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "geometry/reach/posed_solids.h"
#include "geometry/reach/reach_flood.h"

namespace diefill::geometry {

namespace {

constexpr int kPad = 12;   // voxels kept round a solid's box
constexpr int kBlock = 8;  // voxels of a block along each axis

// Nothing above all tools matters: the domain ends two voxels over the highest pose of the highest tool.
VoxelGrid laboratory_grid(const ReachRequest& request) {
  if (!(request.voxel > 0) || !(request.climb >= 0) || !(request.domain.size().minCoeff() > 0))
    throw std::invalid_argument(
        "reach: the voxel and the domain must have a size, the climb must not be negative");
  double top = -1e300;
  for (const auto& solid : request.solids) {
    for (std::size_t i = 0; i < std::min(solid.rotations.size(), solid.translations.size()); ++i) {
      top = std::max(
          top, transformed(*solid.mesh, solid.rotations[i], solid.translations[i]).bounding_box().upper.z());
    }
  }
  Box domain = request.domain;
  const double lowest = domain.lower.z() + request.voxel;
  domain.upper.z() = std::min(domain.upper.z(), std::max(top + 2 * request.voxel, lowest));
  return VoxelGrid::over(domain, request.voxel);
}

// Powder poured from above the grid has fallen to its top.
Box powder_in(const VoxelGrid& grid, Box powder) {
  powder.lower.z() = std::min(powder.lower.z(), grid.origin.z() + (grid.counts.z() - 1) * grid.edge);
  return powder;
}

// The grid's voxels fall on the laboratory's in the first sample, unless the solid is turned.
VoxelGrid grid_round(const Mesh& mesh, const SolidPose& first, const VoxelGrid& laboratory) {
  Box box = mesh.bounding_box();
  const double pad = kPad * laboratory.edge;
  box.lower.array() -= pad;
  box.upper.array() += pad;
  const Eigen::Array3d offset =
      ((box.lower + first.translation - laboratory.origin) / laboratory.edge).array();
  box.lower -= (offset - offset.floor()).matrix() * laboratory.edge;
  return VoxelGrid::over(box, laboratory.edge);
}

// Where powder at `voxel` that a solid moves into ends up: carried along with the solid, then on in the same
// direction until it is clear of the solid. Nothing when it has left the grid or found no room.
std::optional<Eigen::Vector3i> pushed(const VoxelGrid& grid, const Eigen::Vector3i& voxel,
                                      const SolidPose& from, const SolidPose& to,
                                      const PosedSolids::Part& solid) {
  constexpr int kTries = 3;
  const Eigen::Vector3d start = grid.centre(voxel);
  const Eigen::Vector3d step = to.to_laboratory(from.to_body(start)) - start;
  for (int tries = 0; tries < kTries; ++tries) {
    const Eigen::Vector3i end = grid.voxel_at(start + step + tries * grid.edge * step.normalized());
    if (!grid.has(end)) return std::nullopt;
    const Eigen::Vector3i inside = end - solid.first;
    if (!solid.grid.has(inside) || !solid.blocked[solid.grid.index(inside.x(), inside.y(), inside.z())])
      return end;
  }
  return std::nullopt;
}

void push(ReachFlood& flood, const PosedSolids::Part& solid, const SolidPose& from, const SolidPose& to) {
  const auto& counts = solid.grid.counts;
  for (int k = 0; k < counts.z(); ++k) {
    for (int j = 0; j < counts.y(); ++j) {
      for (int i = 0; i < counts.x(); ++i) {
        if (!solid.blocked[solid.grid.index(i, j, k)]) continue;
        const Eigen::Vector3i voxel = solid.first + Eigen::Vector3i(i, j, k);
        if (!flood.reached(voxel)) continue;
        if (const auto end = pushed(flood.grid(), voxel, from, to, solid)) {
          flood.move(voxel, *end);
        } else {
          flood.remove(voxel);
        }
      }
    }
  }
}

void move_on(ReachFlood& flood, PosedSolids& solids, std::size_t solids_count, std::size_t sample) {
  for (std::size_t solid = 0; solid < solids_count; ++solid) {
    if (solids.stands(solid)) continue;
    const auto way = solids.poses_to_next(solid, sample);
    for (std::size_t i = 1; i < way.size(); ++i)
      push(flood, solids.blocked_by(solid, way[i]), way[i - 1], way[i]);
  }
  flood.spread(solids.blocked(sample + 1));
}

// Where there is powder, one byte a voxel, and the box round it.
struct Powder {
  std::vector<std::uint8_t> voxels;
  Box box;

  Powder(const VoxelGrid& grid, std::vector<std::uint8_t> reached) : voxels(std::move(reached)) {
    for (int k = 0; k < grid.counts.z(); ++k) {
      for (int j = 0; j < grid.counts.y(); ++j) {
        const auto row = voxels.begin() + static_cast<std::ptrdiff_t>(grid.index(0, j, k));
        const auto end = row + grid.counts.x();
        const auto first = std::find(row, end, 1);
        if (first == end) continue;
        const auto last = std::find(std::reverse_iterator(end), std::reverse_iterator(row), 1);
        box.include(grid.centre({static_cast<int>(first - row), j, k}));
        box.include(grid.centre({static_cast<int>(last.base() - row) - 1, j, k}));
      }
    }
    box.lower.array() -= grid.edge;
    box.upper.array() += grid.edge;
  }
};

Box in_body(const Box& box, const SolidPose& pose) {
  Box result;
  for (int corner = 0; corner < 8; ++corner) {
    result.include(
        pose.to_body({corner & 1 ? box.lower.x() : box.upper.x(), corner & 2 ? box.lower.y() : box.upper.y(),
                      corner & 4 ? box.lower.z() : box.upper.z()}));
  }
  return result;
}

// Ors the powder into the voxels round a solid.
void gather(const VoxelGrid& laboratory, const Powder& powder, const SolidPose& pose, const VoxelGrid& grid,
            std::vector<std::uint8_t>& reached) {
  const Box box = in_body(powder.box, pose);
  const Eigen::Vector3i lower = grid.voxel_at(box.lower).cwiseMax(0);
  const Eigen::Vector3i upper = grid.voxel_at(box.upper).cwiseMin(grid.counts - Eigen::Vector3i::Ones());
  for (int k = lower.z(); k <= upper.z(); ++k) {
    for (int j = lower.y(); j <= upper.y(); ++j) {
      for (int i = lower.x(); i <= upper.x(); ++i) {
        auto& mark = reached[grid.index(i, j, k)];
        if (mark) continue;
        const Eigen::Vector3i voxel = laboratory.voxel_at(pose.to_laboratory(grid.centre({i, j, k})));
        if (laboratory.has(voxel)) mark = powder.voxels[laboratory.index(voxel.x(), voxel.y(), voxel.z())];
      }
    }
  }
}

}  // namespace

void Reach::Surroundings::mark_blocks() {
  blocks.edge = kBlock * grid.edge;
  blocks.origin = grid.origin;
  blocks.counts = (grid.counts.array() + (kBlock - 1)) / kBlock;
  block_reached.assign(blocks.size(), 0);
  for (int k = 0; k < grid.counts.z(); ++k)
    for (int j = 0; j < grid.counts.y(); ++j)
      for (int i = 0; i < grid.counts.x(); ++i)
        if (reached[grid.index(i, j, k)]) block_reached[blocks.index(i / kBlock, j / kBlock, k / kBlock)] = 1;
}

bool Reach::Surroundings::any_block(const Eigen::Vector3i& lower, const Eigen::Vector3i& upper) const {
  for (int k = lower.z() / kBlock; k <= upper.z() / kBlock; ++k)
    for (int j = lower.y() / kBlock; j <= upper.y() / kBlock; ++j)
      for (int i = lower.x() / kBlock; i <= upper.x() / kBlock; ++i)
        if (block_reached[blocks.index(i, j, k)]) return true;
  return false;
}

Reach::Reach(const ReachRequest& request) : laboratory_(laboratory_grid(request)) {
  PosedSolids solids(request.solids, laboratory_);
  const auto count = request.solids.size();
  for (std::size_t i = 0; i < count; ++i) {
    const VoxelGrid grid = grid_round(*request.solids[i].mesh, solids.pose(i, 0), laboratory_);
    surroundings_.push_back({grid, std::vector<std::uint8_t>(grid.size(), 0), {}, {}});
  }
  ReachFlood flood(laboratory_, request.climb, request.scatters);
  std::vector<Box> powder_boxes;
  for (const Box& box : request.powder) powder_boxes.push_back(powder_in(laboratory_, box));
  flood.pour(powder_boxes, solids.blocked(0));
  first_ = flood.reached_voxels();
  auto ever = first_;
  for (std::size_t sample = 0; sample < solids.samples(); ++sample) {
    if (sample > 0) move_on(flood, solids, count, sample - 1);
    const Powder powder(laboratory_, flood.reached_voxels());
    std::transform(powder.voxels.begin(), powder.voxels.end(), ever.begin(), ever.begin(),
                   std::bit_or<std::uint8_t>());
    for (std::size_t i = 0; i < count; ++i) {
      if (solids.stands(i)) continue;
      gather(laboratory_, powder, solids.pose(i, sample), surroundings_[i].grid, surroundings_[i].reached);
    }
  }
  const Powder powder(laboratory_, std::move(ever));
  for (std::size_t i = 0; i < count; ++i) {
    if (!solids.stands(i)) continue;
    gather(laboratory_, powder, solids.pose(i, 0), surroundings_[i].grid, surroundings_[i].reached);
  }
  for (auto& surroundings : surroundings_) surroundings.mark_blocks();
}

bool Reach::reachable(std::size_t solid, const Eigen::Vector3d& point_in_body,
                      const Eigen::Vector3d& outward_normal, double margin) const {
  const Surroundings& surroundings = surroundings_.at(solid);
  const auto& grid = surroundings.grid;
  const auto& reached = surroundings.reached;
  const double radius = margin + grid.edge;
  const auto is_reached = [&](const Eigen::Vector3i& voxel) {
    return reached[grid.index(voxel.x(), voxel.y(), voxel.z())] != 0;
  };
  // Most answers lie straight ahead.
  const Eigen::Vector3i ahead = grid.voxel_at(point_in_body + outward_normal * grid.edge);
  if (grid.has(ahead) && is_reached(ahead)) return true;
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(radius);
  const Eigen::Vector3i lower = grid.voxel_at(point_in_body - reach).cwiseMax(0);
  const Eigen::Vector3i upper =
      grid.voxel_at(point_in_body + reach).cwiseMin(grid.counts - Eigen::Vector3i::Ones());
  if ((lower.array() > upper.array()).any() || !surroundings.any_block(lower, upper)) return false;
  for (int k = lower.z(); k <= upper.z(); ++k) {
    for (int j = lower.y(); j <= upper.y(); ++j) {
      for (int i = lower.x(); i <= upper.x(); ++i) {
        if (!is_reached({i, j, k})) continue;
        const Eigen::Vector3d offset = grid.centre({i, j, k}) - point_in_body;
        if (offset.dot(outward_normal) > 0 && offset.squaredNorm() <= radius * radius) return true;
      }
    }
  }
  return false;
}

}  // namespace diefill::geometry
