#include "process/measure/volumes/grid_shares.h"

#include <algorithm>
#include <cmath>

#include "process/measure/volumes/sphere_overlap.h"

namespace diefill::process {
namespace {

/// Places of a range's edges from the sphere's centre, in radii; beyond the sphere -1 and 1.
std::vector<double> edge_places(const std::vector<double>& edges, const CellRange& range, double centre,
                                double radius) {
  std::vector<double> places;
  for (std::size_t k = range.first; k <= range.last + 1; ++k)
    places.push_back(std::clamp((edges[k] - centre) / radius, -1.0, 1.0));
  return places;
}

bool is_whole(const std::vector<double>& places) {
  return places.size() == 2 && places.front() <= -1 && places.back() >= 1;
}

}  // namespace

CellRange cells_between(const std::vector<double>& edges, double lower, double upper) {
  CellRange range;
  if (edges.size() < 2 || upper <= edges.front() || lower >= edges.back()) return range;
  const auto at_or_below = [&](double value) {
    const auto above = std::upper_bound(edges.begin(), edges.end(), value);
    return above == edges.begin() ? 0 : static_cast<std::size_t>(above - edges.begin()) - 1;
  };
  range.first = at_or_below(lower);
  range.last = std::min(at_or_below(upper), edges.size() - 2);
  range.empty = false;
  return range;
}

void share_sphere(results::CellField& field, const std::array<double, 3>& centre, double radius,
                  double weight) {
  std::array<CellRange, 3> range;
  std::array<std::vector<double>, 3> places;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    range[axis] = cells_between(field.edges[axis], centre[axis] - radius, centre[axis] + radius);
    if (range[axis].empty) return;
    places[axis] = edge_places(field.edges[axis], range[axis], centre[axis], radius);
  }
  const double scale = weight * radius * radius * radius;
  const auto cell_at = [&](std::size_t i, std::size_t j, std::size_t k) {
    return field.cell(range[0].first + i, range[1].first + j, range[2].first + k);
  };
  if (is_whole(places[0]) && is_whole(places[1]) && is_whole(places[2])) {
    field.value[cell_at(0, 0, 0)] += scale * ball_beyond(-1);
    return;
  }
  // The part beyond each node of the grid; differences of these are the cells'.
  const std::size_t columns = places[0].size(), rows = places[1].size();
  std::vector<double> beyond;
  beyond.reserve(columns * rows * places[2].size());
  for (const double c : places[2])
    for (const double b : places[1])
      for (const double a : places[0]) beyond.push_back(ball_beyond(a, b, c));
  const auto column_of = [&](std::size_t i, std::size_t j, std::size_t k) {
    const std::size_t node = (k * rows + j) * columns + i;
    return beyond[node] - beyond[node + 1];
  };
  for (std::size_t k = 0; k + 1 < places[2].size(); ++k)
    for (std::size_t j = 0; j + 1 < rows; ++j)
      for (std::size_t i = 0; i + 1 < columns; ++i)
        field.value[cell_at(i, j, k)] +=
            scale * std::max(0.0, (column_of(i, j, k) - column_of(i, j + 1, k)) -
                                      (column_of(i, j, k + 1) - column_of(i, j + 1, k + 1)));
}

}  // namespace diefill::process
