#include "process/measure/fields/powder_places.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "process/measure/period.h"

namespace diefill::process {
namespace {

std::vector<Eigen::Vector3d> with_images(const results::PowderState& powder, double margin) {
  return geometry::with_periodic_images(powder.position, period_of(powder), margin).points;
}

/// How far columns may lie beside a node at each row's distance.
std::vector<long> half_widths(const NodeGrid& grid, double depth) {
  std::vector<long> widths;
  const auto rows = static_cast<long>(depth / grid.second_step);
  for (long row = 0; row <= rows; ++row) {
    const double height = static_cast<double>(row) * grid.second_step;
    widths.push_back(static_cast<long>(std::sqrt(depth * depth - height * height) / grid.first_step));
  }
  return widths;
}

/// The column that stands at `column`, of a closed axis once round; none beyond the grid.
std::optional<std::size_t> column_at(const NodeGrid& grid, long column) {
  const auto columns = static_cast<long>(grid.columns), turn = columns - 1;
  const long place = grid.closed ? (column % turn + turn) % turn : column;
  if (place < 0 || place >= columns) return std::nullopt;
  return static_cast<std::size_t>(place);
}

/// Whether a node is not near while one beside it is.
bool at_edge(const std::vector<std::uint8_t>& near, const NodeGrid& grid, long i, long j) {
  const auto is_near = [&](long column, long row) {
    const auto place = column_at(grid, column);
    return place && row >= 0 && row < static_cast<long>(grid.rows) &&
           near[static_cast<std::size_t>(row) * grid.columns + *place] != 0;
  };
  return !is_near(i, j) && (is_near(i - 1, j) || is_near(i + 1, j) || is_near(i, j - 1) || is_near(i, j + 1));
}

/// Clears the nodes of a row within `width` columns of `middle`.
void clear_row(std::vector<std::uint8_t>& near, const NodeGrid& grid, long row, long middle, long width) {
  const std::size_t first = static_cast<std::size_t>(row) * grid.columns;
  const long most = std::min(width, static_cast<long>(grid.columns) - 1);
  for (long column = middle - most; column <= middle + most; ++column)
    if (const auto place = column_at(grid, column)) {
      near[first + *place] = 0;
      if (grid.closed && *place == 0) near[first + grid.columns - 1] = 0;
    }
}

}  // namespace

PowderPlaces::PowderPlaces(const results::PowderState& powder)
    : diameter_(powder.grain_diameter),
      reach_(kReachOverDiameter * powder.grain_diameter),
      grid_(with_images(powder, reach_), reach_) {}

bool PowderPlaces::near(const Eigen::Vector3d& point) const {
  bool found = false;
  grid_.for_each_within(point, reach_, [&](std::uint32_t, const auto&, double) { found = true; });
  return found;
}

void erode_edges(std::vector<std::uint8_t>& near, const NodeGrid& grid, double depth,
                 const std::function<bool(std::size_t, std::size_t)>& is_tool) {
  if (grid.columns < 2 || grid.rows < 1) return;
  const std::vector<std::uint8_t> before = near;
  const std::vector<long> widths = half_widths(grid, depth);
  const auto rows = static_cast<long>(grid.rows), reach = static_cast<long>(widths.size()) - 1;
  for (long j = 0; j < rows; ++j)
    for (long i = 0; i < static_cast<long>(grid.columns); ++i) {
      if (!at_edge(before, grid, i, j) || is_tool(static_cast<std::size_t>(i), static_cast<std::size_t>(j)))
        continue;
      for (long row = std::max(0L, j - reach); row <= std::min(rows - 1, j + reach); ++row)
        clear_row(near, grid, row, i, widths[static_cast<std::size_t>(std::abs(row - j))]);
    }
}

}  // namespace diefill::process
