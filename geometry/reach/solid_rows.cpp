#include "geometry/reach/solid_rows.h"

#include <algorithm>
#include <cmath>

namespace diefill::geometry {
namespace {

bool starts_before(const SolidRows::Row& one, const SolidRows::Row& other) {
  return one.row != other.row ? one.row < other.row : one.span.begin < other.span.begin;
}

}  // namespace

SolidRows::SolidRows(const Mesh& mesh, const VoxelGrid& grid, int axis, LineCrossings& crossings)
    : axis_(axis) {
  const auto found = crossings.find(mesh, grid, axis);
  rows_.reserve(found.size() / 2);
  int depth = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& crossing = found[i];
    if (i == 0 || crossing.row != found[i - 1].row) depth = 0;
    if (depth == 0 && crossing.winding > 0) rows_.push_back({crossing.row, {crossing.along, crossing.along}});
    depth = std::max(0, depth + crossing.winding);
    if (!rows_.empty() && rows_.back().row == crossing.row) rows_.back().span.end = crossing.along;
  }
}

std::vector<SolidRows::Row> joined_rows(std::span<const SolidRows* const> solids, double closing) {
  std::vector<SolidRows::Row> all;
  std::size_t count = 0;
  for (const auto* solid : solids) count += solid->rows().size();
  all.reserve(count);
  for (const auto* solid : solids) {
    const auto middle = static_cast<std::ptrdiff_t>(all.size());
    all.insert(all.end(), solid->rows().begin(), solid->rows().end());
    std::inplace_merge(all.begin(), all.begin() + middle, all.end(), starts_before);
  }
  std::vector<SolidRows::Row> joined;
  joined.reserve(count);
  for (const auto& row : all) {
    const bool continues =
        !joined.empty() && joined.back().row == row.row && row.span.begin < joined.back().span.end + closing;
    if (continues) {
      joined.back().span.end = std::max(joined.back().span.end, row.span.end);
    } else {
      joined.push_back(row);
    }
  }
  return joined;
}

void block(const VoxelGrid& grid, int axis, std::span<const SolidRows::Row> rows,
           std::vector<std::uint8_t>& blocked) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Eigen::Vector3i strides(1, grid.counts.x(), grid.counts.x() * grid.counts.y());
  const auto count = static_cast<double>(grid.counts[axis]);
  for (const auto& [row, span] : rows) {
    double first = std::ceil((span.begin - grid.origin[axis]) / grid.edge - 0.5);
    double last = std::floor((span.end - grid.origin[axis]) / grid.edge - 0.5);
    if (first > last)
      first = last = std::floor(((span.begin + span.end) / 2 - grid.origin[axis]) / grid.edge);
    first = std::max(first, 0.0);
    last = std::min(last, count - 1);
    const auto width = static_cast<std::size_t>(grid.counts[u]);
    const auto start = row % width * static_cast<std::size_t>(strides[u]) +
                       row / width * static_cast<std::size_t>(strides[v]);
    for (auto voxel = static_cast<std::ptrdiff_t>(first); voxel <= static_cast<std::ptrdiff_t>(last);
         ++voxel) {
      blocked[start + static_cast<std::size_t>(voxel) * static_cast<std::size_t>(strides[axis])] = 1;
    }
  }
}

std::vector<std::uint8_t> blocked_voxels(const VoxelGrid& grid, std::span<const Mesh* const> meshes,
                                         double closing) {
  std::vector<std::uint8_t> blocked(grid.size(), 0);
  LineCrossings crossings;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<SolidRows> solids;
    for (const auto* mesh : meshes) solids.emplace_back(*mesh, grid, axis, crossings);
    std::vector<const SolidRows*> pointers;
    for (const auto& solid : solids) pointers.push_back(&solid);
    block(grid, axis, joined_rows(pointers, closing), blocked);
  }
  return blocked;
}

void close_short_stretches(const VoxelGrid& grid, double closing, std::vector<std::uint8_t>& blocked) {
  const auto longest = static_cast<int>(closing / grid.edge);
  for (int axis = 0; axis < 3 && longest > 0; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto at = [&, axis](Eigen::Vector3i voxel, int along) -> std::uint8_t& {
      voxel[axis] = along;
      return blocked[grid.index(voxel.x(), voxel.y(), voxel.z())];
    };
    Eigen::Vector3i line = Eigen::Vector3i::Zero();
    for (line[v] = 0; line[v] < grid.counts[v]; ++line[v]) {
      for (line[u] = 0; line[u] < grid.counts[u]; ++line[u]) {
        int last_blocked = -longest - 2;  // the border of the grid closes nothing
        for (int along = 0; along < grid.counts[axis]; ++along) {
          if (!at(line, along)) continue;
          const bool is_short = along - last_blocked - 1 <= longest;
          for (int free = last_blocked + 1; is_short && free < along; ++free) at(line, free) = 1;
          last_blocked = along;
        }
      }
    }
  }
}

}  // namespace diefill::geometry
