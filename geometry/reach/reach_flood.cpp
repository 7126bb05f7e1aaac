#include "geometry/reach/reach_flood.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace diefill::geometry {
namespace {

// Free voxels of one layer, flooded sideways; reports whether the border is reached.
class LayerFlood {
 public:
  LayerFlood(const VoxelGrid& grid, int layer, const std::vector<std::uint8_t>& blocked)
      : grid_(grid),
        layer_(layer),
        blocked_(blocked),
        seen_(static_cast<std::size_t>(grid.counts.x() * grid.counts.y())) {}

  void enter(int i, int j) {
    auto& seen = seen_[static_cast<std::size_t>(j * grid_.counts.x() + i)];
    if (seen || blocked_[grid_.index(i, j, layer_)]) return;
    seen = 1;
    started_ = true;
    front_.emplace_back(i, j);
  }

  // `closed[axis][side]`: the border there is none to run over.
  bool stays_inside(const std::array<std::array<bool, 2>, 2>& closed) {
    while (!front_.empty()) {
      const Eigen::Vector2i at = front_.back();
      front_.pop_back();
      for (std::size_t axis = 0; axis < 2; ++axis) {
        for (const std::size_t side : {0U, 1U}) {
          Eigen::Vector2i next = at;
          next[static_cast<int>(axis)] += side == 0 ? -1 : 1;
          const bool outside =
              (next.array() < 0).any() || (next.array() >= grid_.counts.head<2>().array()).any();
          if (!outside) enter(next.x(), next.y());
          if (outside && !closed[axis][side]) return false;
        }
      }
    }
    return started_;
  }

 private:
  const VoxelGrid& grid_;
  int layer_;
  const std::vector<std::uint8_t>& blocked_;
  std::vector<std::uint8_t> seen_;
  std::vector<Eigen::Vector2i> front_;
  bool started_ = false;
};

}  // namespace

// What scatters loses no height on its way: to rise beyond the grid is to rise to its top, however high tools
// that are shaken hard would throw it.
std::int32_t ReachFlood::climb_in(const VoxelGrid& grid, double climb, bool scatters) {
  const double quarters = std::ceil(kVoxel * climb / grid.edge);
  const double enough = kVoxel * (scatters ? grid.counts.z() : 4 * grid.counts.sum());
  return static_cast<std::int32_t>(std::min(quarters, enough));
}

ReachFlood::ReachFlood(const VoxelGrid& grid, double climb, bool scatters)
    : grid_(grid),
      climb_(climb_in(grid, climb, scatters)),
      loss_(scatters ? 0 : kLossOfHeap),
      ceiling_(grid.counts.z() - 1),
      heads_(grid.size(), kNone),
      waiting_(static_cast<std::size_t>(highest_head(grid.counts.z())) + 1) {}

void ReachFlood::pour(const std::vector<Box>& boxes, const std::vector<std::uint8_t>& blocked) {
  ceiling_ = 0;
  for (const Box& box : boxes) {
    ceiling_ = std::max(ceiling_, holding_layer(box, blocked));
    place(box);
  }
  spread(blocked);
  drop_falling();
}

void ReachFlood::place(const Box& box) {
  const Eigen::Vector3i lower = grid_.voxel_at(box.lower).cwiseMax(0);
  const Eigen::Vector3i upper = grid_.voxel_at(box.upper).cwiseMin(grid_.counts - Eigen::Vector3i::Ones());
  for (int k = lower.z(); k <= upper.z(); ++k)
    for (int j = lower.y(); j <= upper.y(); ++j)
      for (int i = lower.x(); i <= upper.x(); ++i)
        if (box.contains(grid_.centre({i, j, k}))) head({i, j, k}) = highest_head(k);
}

// A border that the box itself reaches is no way out: there the powder goes on periodically, or is cut off on
// purpose.
int ReachFlood::holding_layer(const Box& box, const std::vector<std::uint8_t>& blocked) const {
  const int top = grid_.counts.z() - 1;
  for (int layer = top; layer >= std::clamp(grid_.voxel_at(box.lower).z(), 0, top); --layer) {
    LayerFlood flood(grid_, layer, blocked);
    std::array<std::array<bool, 2>, 2> closed{};
    for (int axis = 0; axis < 2; ++axis) {
      const double end = grid_.origin[axis] + grid_.counts[axis] * grid_.edge;
      closed[static_cast<std::size_t>(axis)] = {
          box.lower[axis]<grid_.origin[axis] + grid_.edge, box.upper[axis]> end - 2 * grid_.edge};
    }
    for (int j = 0; j < grid_.counts.y(); ++j) {
      for (int i = 0; i < grid_.counts.x(); ++i) {
        Eigen::Vector3d centre = grid_.centre({i, j, layer});
        centre.z() = box.lower.z();
        if (box.contains(centre)) flood.enter(i, j);
      }
    }
    if (flood.stays_inside(closed)) return layer;
  }
  return top;
}

void ReachFlood::spread(const std::vector<std::uint8_t>& blocked) {
  for (std::size_t i = 0; i < heads_.size(); ++i) {
    if (blocked[i]) heads_[i] = kNone;
  }
  for (int k = 0; k < grid_.counts.z(); ++k) {
    for (int j = 0; j < grid_.counts.y(); ++j) {
      for (int i = 0; i < grid_.counts.x(); ++i) {
        const Eigen::Vector3i voxel(i, j, k);
        if (!reached(voxel)) continue;
        bool spreads = false;
        for_ways_on(voxel, [&](const Eigen::Vector3i& next, std::int32_t new_head) {
          spreads = spreads || would_enter(next, new_head, blocked);
        });
        if (spreads) waiting_[static_cast<std::size_t>(head(voxel))].push_back(voxel);
      }
    }
  }
  // From the highest head down: a voxel is first left with the highest head it will ever get.
  for (std::size_t bucket = waiting_.size(); bucket-- > 0;) {
    auto& front = waiting_[bucket];
    while (!front.empty()) {
      const Eigen::Vector3i voxel = front.back();
      front.pop_back();
      if (head(voxel) != static_cast<std::int32_t>(bucket)) continue;
      for_ways_on(voxel, [&](const Eigen::Vector3i& next, std::int32_t new_head) {
        if (!would_enter(next, new_head, blocked)) return;
        head(next) = new_head;
        waiting_[static_cast<std::size_t>(new_head)].push_back(next);
      });
    }
  }
}

// Calls `visit` with the voxels powder may go to next and the head it has there.
template <typename Visit>
void ReachFlood::for_ways_on(const Eigen::Vector3i& voxel, Visit visit) const {
  const std::int32_t here = heads_[grid_.index(voxel.x(), voxel.y(), voxel.z())];
  if (voxel.z() > 0) visit(voxel - Eigen::Vector3i::UnitZ(), std::min(here, highest_head(voxel.z() - 1)));
  if (voxel.z() > ceiling_) return;
  if (voxel.z() < ceiling_) visit(voxel + Eigen::Vector3i::UnitZ(), here);
  const bool risen = here < highest_head(voxel.z());
  const std::int32_t sideways = risen ? here - loss_ : here;
  for (int axis = 0; axis < 2; ++axis) {
    Eigen::Vector3i next = voxel;
    next[axis] = voxel[axis] - 1;
    if (next[axis] >= 0) visit(next, sideways);
    next[axis] = voxel[axis] + 1;
    if (next[axis] < grid_.counts[axis]) visit(next, sideways);
  }
}

bool ReachFlood::would_enter(const Eigen::Vector3i& voxel, std::int32_t new_head,
                             const std::vector<std::uint8_t>& blocked) const {
  const auto index = grid_.index(voxel.x(), voxel.y(), voxel.z());
  return !blocked[index] && new_head >= kVoxel * voxel.z() && new_head > heads_[index];
}

std::vector<std::uint8_t> ReachFlood::reached_voxels() const {
  std::vector<std::uint8_t> reached(heads_.size());
  std::transform(heads_.begin(), heads_.end(), reached.begin(),
                 [](std::int32_t head) { return static_cast<std::uint8_t>(head != kNone); });
  return reached;
}

void ReachFlood::drop_falling() {
  for (int k = ceiling_ + 1; k < grid_.counts.z(); ++k) {
    const auto begin = heads_.begin() + static_cast<std::ptrdiff_t>(grid_.index(0, 0, k));
    std::fill(begin, begin + static_cast<std::ptrdiff_t>(grid_.counts.x()) * grid_.counts.y(), kNone);
  }
}

void ReachFlood::move(const Eigen::Vector3i& from, const Eigen::Vector3i& to) {
  Eigen::Vector3i end = to;
  const bool lifted = to.z() > from.z();
  while (lifted && end.z() < ceiling_ && reached(end)) ++end.z();
  const std::int32_t lowest = kVoxel * end.z();
  const std::int32_t moved =
      lifted ? highest_head(end.z()) : std::clamp(head(from), lowest, highest_head(end.z()));
  head(from) = kNone;
  head(end) = std::max(head(end), moved);
}

}  // namespace diefill::geometry
