#include "geometry/cavity/cavity_region.h"

#include <algorithm>
#include <optional>

#include "geometry/reach/solid_rows.h"

namespace diefill::geometry {
namespace {

// Spaces below this share of the largest cavity are pockets in tools that nobody fills.
constexpr double kSmallestShare = 0.01;

class Components {
 public:
  struct Enclosed {
    std::int32_t label;
    std::size_t size;  // voxels
  };

  Components(const VoxelGrid& grid, const std::vector<std::uint8_t>& blocked)
      : grid_(grid), labels_(blocked.size(), 0) {
    for (std::size_t i = 0; i < blocked.size(); ++i) labels_[i] = blocked[i] ? kBlocked : 0;
    for (int j = 0; j < grid.counts.y(); ++j) {
      for (int i = 0; i < grid.counts.x(); ++i) grow({i, j, grid.counts.z() - 1});
    }
  }

  // Components without a way out, by falling size.
  std::vector<Enclosed> enclosed() const {
    std::vector<Enclosed> sorted = enclosed_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Enclosed& a, const Enclosed& b) { return a.size > b.size; });
    return sorted;
  }
  const std::vector<std::int32_t>& labels() const { return labels_; }

 private:
  static constexpr std::int32_t kBlocked = -1;

  // Row by row along x, which lie together in memory.
  void grow(const Eigen::Vector3i& seed) {
    if (labels_[at(seed)] != 0) return;
    ++last_;
    std::size_t size = 0;
    bool leaks = false;
    std::vector<Eigen::Vector3i> front = {seed};
    while (!front.empty()) {
      const Eigen::Vector3i voxel = front.back();
      front.pop_back();
      if (labels_[at(voxel)] != 0) continue;
      const auto [first, last] = take_row(voxel);
      size += static_cast<std::size_t>(last - first + 1);
      leaks = leaks || first == 0 || last == grid_.counts.x() - 1;
      for (const int axis : {1, 2}) {
        for (const int step : {-1, 1}) {
          Eigen::Vector3i row = voxel;
          row[axis] += step;
          if (grid_.has(row)) {
            add_free_stretches(row, first, last, front);
          } else if (axis == 1 || step < 0) {
            leaks = true;
          }
        }
      }
    }
    if (!leaks) enclosed_.push_back({last_, size});
  }

  std::size_t at(const Eigen::Vector3i& voxel) const { return grid_.index(voxel.x(), voxel.y(), voxel.z()); }

  // Labels the free voxels of a row on both sides of one of them; the first and the last.
  std::pair<int, int> take_row(const Eigen::Vector3i& voxel) {
    std::int32_t* const row = &labels_[grid_.index(0, voxel.y(), voxel.z())];
    int first = voxel.x(), last = voxel.x();
    while (first > 0 && row[first - 1] == 0) --first;
    while (last + 1 < grid_.counts.x() && row[last + 1] == 0) ++last;
    std::fill(row + first, row + last + 1, last_);
    return {first, last};
  }

  // Puts one voxel of every free stretch of a row between two places into `front`.
  void add_free_stretches(const Eigen::Vector3i& in_row, int first, int last,
                          std::vector<Eigen::Vector3i>& front) const {
    const std::int32_t* const row = &labels_[grid_.index(0, in_row.y(), in_row.z())];
    for (int i = first; i <= last; ++i)
      if (row[i] == 0 && (i == first || row[i - 1] != 0)) front.emplace_back(i, in_row.y(), in_row.z());
  }

  const VoxelGrid& grid_;
  std::vector<std::int32_t> labels_;
  std::int32_t last_ = 0;
  std::vector<Enclosed> enclosed_;
};

// Follows the lines of voxel centres along one axis through the cavity, from solid to solid.
class LineMeasure {
 public:
  LineMeasure(const CavityRegion& region, std::span<const Mesh* const> solids, int axis)
      : region_(region), axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3) {
    std::vector<SolidRows> rows;
    LineCrossings crossings;
    for (const auto* mesh : solids) rows.emplace_back(*mesh, region.grid, axis, crossings);
    std::vector<const SolidRows*> pointers;
    for (const auto& row : rows) pointers.push_back(&row);
    rows_ = joined_rows(pointers, kLargestFit);
    measure();
  }

  double lower = 1e300, upper = -1e300;  // m, where the lines first and last meet walls of the cavity
  double volume = 0;                     // m^3

 private:
  void measure() {
    const auto& counts = region_.grid.counts;
    std::size_t begin = 0;
    Eigen::Vector3i line = Eigen::Vector3i::Zero();
    for (line[v_] = 0; line[v_] < counts[v_]; ++line[v_]) {
      for (line[u_] = 0; line[u_] < counts[u_]; ++line[u_]) {
        const auto row = static_cast<std::size_t>(line[v_] * counts[u_] + line[u_]);
        while (begin < rows_.size() && rows_[begin].row < row) ++begin;
        auto end = begin;
        while (end < rows_.size() && rows_[end].row == row) ++end;
        measure_line(line, {rows_.data() + begin, rows_.data() + end});
      }
    }
  }

  bool inside(Eigen::Vector3i line, int at) const {
    line[axis_] = at;
    return region_.grid.has(line) && region_.inside[region_.grid.index(line.x(), line.y(), line.z())];
  }

  void measure_line(const Eigen::Vector3i& line, std::span<const SolidRows::Row> solid) {
    for (int first = 0; first < region_.grid.counts[axis_]; ++first) {
      if (!inside(line, first) || inside(line, first - 1)) continue;
      int last = first;
      while (inside(line, last + 1)) ++last;
      add_stretch(first, last, solid);
    }
  }

  // From the solid before the first voxel centre to the solid after the last, or to the fill plane. A line
  // that runs into a closed fit has no wall there: it takes the voxels' ends and says nothing about where
  // walls are.
  void add_stretch(int first, int last, std::span<const SolidRows::Row> solid) {
    const double edge = region_.grid.edge, start = region_.grid.origin[axis_];
    const double before = start + first * edge, after = start + (last + 1) * edge;
    std::optional<double> begin, end;
    for (const auto& [row, span] : solid) {
      if (span.end <= before + edge / 2 && span.end > before - edge) begin = span.end;
      if (span.begin < after - edge / 2) continue;
      if (span.begin < after + edge) end = span.begin;
      break;
    }
    const bool below_fill_plane = axis_ == 2 && last == region_.grid.counts.z() - 1;
    if (below_fill_plane) end = after;
    volume += (end.value_or(after) - begin.value_or(before)) * edge * edge;
    if (begin) lower = std::min(lower, *begin);
    if (end) upper = std::max(upper, *end);
  }

  const CavityRegion& region_;
  int axis_, u_, v_;
  std::vector<SolidRows::Row> rows_;
};

CavityRegion region_of(std::span<const Mesh* const> solids, const VoxelGrid& grid,
                       const std::vector<std::int32_t>& labels, std::int32_t label) {
  CavityRegion region;
  region.grid = grid;
  region.inside.resize(grid.size());
  std::transform(labels.begin(), labels.end(), region.inside.begin(),
                 [label](std::int32_t other) { return static_cast<std::uint8_t>(other == label); });
  for (int axis = 0; axis < 3; ++axis) {
    const LineMeasure lines(region, solids, axis);
    region.box.lower[axis] = lines.lower;
    region.box.upper[axis] = lines.upper;
    region.volume = lines.volume;
  }
  region.box.upper.z() = grid.origin.z() + grid.counts.z() * grid.edge;
  return region;
}

}  // namespace

std::vector<CavityRegion> find_cavity_regions(std::span<const Mesh* const> solids, const VoxelGrid& grid) {
  auto blocked = blocked_voxels(grid, solids, kLargestFit);
  close_short_stretches(grid, kLargestFit, blocked);
  const Components components(grid, blocked);
  const auto enclosed = components.enclosed();
  std::vector<CavityRegion> regions;
  for (const auto& one : enclosed)
    if (static_cast<double>(one.size) >= kSmallestShare * static_cast<double>(enclosed.front().size))
      regions.push_back(region_of(solids, grid, components.labels(), one.label));
  return regions;
}

}  // namespace diefill::geometry
