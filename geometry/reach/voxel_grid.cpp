#include "geometry/reach/voxel_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "geometry/grids/all_cores.h"
#include "geometry/mesh/topology.h"

namespace diefill::geometry {
namespace {

constexpr double kMostVoxels = 2e8;  // a flood of them takes some two gigabytes

struct Crossing {
  std::size_t row;
  double along;
  int winding;  // +1 where the line enters the solid
};

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

// Arrays that tools on their way need again at every place: where freed ones go back to the system, to take
// and to free them costs more than the sums. No work is handed to other threads while they are in use.
struct Scratch {
  std::vector<Crossing> crossings, sorted;
  std::vector<std::size_t> ends;

  void clear() {
    constexpr std::size_t kMostKept = 1 << 17;  // crossings, 3 MB
    if (crossings.capacity() > kMostKept || ends.capacity() > kMostKept) *this = Scratch();
  }
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

// By line, then along the line. Entering comes first where shells touch, so that they become one stretch.
// Lines have few crossings each: counting them out by line is many times faster than comparing all.
void sort(Scratch& scratch, std::size_t lines) {
  auto& [crossings, sorted, ends] = scratch;
  ends.assign(lines + 1, 0);
  for (const auto& crossing : crossings) ++ends[crossing.row + 1];
  for (std::size_t line = 0; line < lines; ++line) ends[line + 1] += ends[line];
  sorted.resize(crossings.size());
  for (const auto& crossing : crossings) sorted[ends[crossing.row]++] = crossing;
  const auto before = [](const Crossing& one, const Crossing& other) {
    return one.along != other.along ? one.along < other.along : one.winding > other.winding;
  };
  for (auto begin = sorted.begin(); begin != sorted.end();) {
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(ends[begin->row]);
    if (end - begin > 1) std::sort(begin, end, before);
    begin = end;
  }
  crossings.swap(sorted);
}

bool starts_before(const SolidRows::Row& one, const SolidRows::Row& other) {
  return one.row != other.row ? one.row < other.row : one.span.begin < other.span.begin;
}

}  // namespace

VoxelGrid VoxelGrid::over(const Box& box, double edge) {
  const Eigen::Vector3d voxels = box.size() / edge;
  if (!(voxels.cwiseMax(1).prod() <= kMostVoxels)) {
    char text[280];
    std::snprintf(text, sizeof text,
                  "the volume of %.4g x %.4g x %.4g mm occupied by tools and powder is too large to search "
                  "in steps of %.3g mm; check whether a position or a motion has the wrong unit",
                  1e3 * box.size()[0], 1e3 * box.size()[1], 1e3 * box.size()[2], 1e3 * edge);
    throw MeshError(text);
  }
  return {box.lower, edge, (voxels.array() - 1e-9).ceil().max(1).cast<int>().matrix()};
}

std::size_t VoxelGrid::size() const {
  return static_cast<std::size_t>(counts.x()) * static_cast<std::size_t>(counts.y()) *
         static_cast<std::size_t>(counts.z());
}

Eigen::Vector3i VoxelGrid::voxel_at(const Eigen::Vector3d& point) const {
  // Far points would overflow an int: anything beyond the grid is as good as just beyond it.
  const Eigen::Array3d voxel = ((point - origin) / edge).array().floor();
  return voxel.max(-1.0).min(counts.cast<double>().array()).cast<int>().matrix();
}

SolidRows::SolidRows(const Mesh& mesh, const VoxelGrid& grid, int axis) : axis_(axis) {
  // In an array of its own until all threads are done: this one may take up other work while it waits.
  static thread_local Scratch scratch;
  std::vector<Crossing> found = std::exchange(scratch.crossings, {});
  find_crossings(mesh, grid, axis, found);
  scratch.crossings = std::move(found);
  sort(scratch, static_cast<std::size_t>(grid.counts[(axis + 1) % 3]) *
                    static_cast<std::size_t>(grid.counts[(axis + 2) % 3]));
  const std::vector<Crossing>& crossings = scratch.crossings;
  rows_.reserve(crossings.size() / 2);
  int depth = 0;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const auto& crossing = crossings[i];
    if (i == 0 || crossing.row != crossings[i - 1].row) depth = 0;
    if (depth == 0 && crossing.winding > 0) rows_.push_back({crossing.row, {crossing.along, crossing.along}});
    depth = std::max(0, depth + crossing.winding);
    if (!rows_.empty() && rows_.back().row == crossing.row) rows_.back().span.end = crossing.along;
  }
  scratch.clear();
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
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<SolidRows> solids;
    for (const auto* mesh : meshes) solids.emplace_back(*mesh, grid, axis);
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
