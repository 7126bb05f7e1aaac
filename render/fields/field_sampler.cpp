#include "render/fields/field_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "process/results/places_without_value.h"

namespace diefill::render {
namespace {

constexpr double kFullTurn = 360;

// The grid interval that holds a coordinate, and how far along it the coordinate lies (0..1).
struct CellWeights {
  std::size_t below;
  double weight;
};

CellWeights find_place(const std::vector<double>& nodes, double coordinate) {
  const double inside = std::clamp(coordinate, nodes.front(), nodes.back());
  const auto above = std::upper_bound(nodes.begin() + 1, nodes.end() - 1, inside);
  const auto below = static_cast<std::size_t>(above - nodes.begin()) - 1;
  return {below, (inside - nodes[below]) / (nodes[below + 1] - nodes[below])};
}

bool finite_and_rising(const std::vector<double>& nodes) {
  return nodes.size() >= 2 &&
         std::all_of(nodes.begin(), nodes.end(), [](double v) { return std::isfinite(v); }) &&
         std::adjacent_find(nodes.begin(), nodes.end(), std::greater_equal<>()) == nodes.end();
}

}  // namespace

bool has_azimuth(const results::Field2D& field) {
  return field.first_name == "azimuth" && (field.first_unit == "deg" || field.first_unit == "°");
}

void check_field(const results::Field2D& field) {
  const std::string name = "field '" + field.quantity + "': ";
  if (!finite_and_rising(field.first) || !finite_and_rising(field.second))
    throw std::runtime_error(name + "its " + field.first_name + " and " + field.second_name +
                             " need at least two finite coordinates each, in rising order");
  const std::size_t nodes = field.first.size() * field.second.size();
  if (field.value.size() != nodes)
    throw std::runtime_error(name + "it has " + std::to_string(field.value.size()) + " values for " +
                             std::to_string(nodes) + " grid nodes");
}

results::Field2D continued_round(const results::Field2D& field) {
  if (!has_azimuth(field)) return field;
  const std::size_t columns = field.first.size();
  // Nodes at both 0 and 360 are the same place: the last then adds nothing beyond the turn.
  const bool closed = field.first.back() - field.first.front() >= kFullTurn - 1e-9;
  const std::size_t last = closed ? columns - 2 : columns - 1;
  const std::size_t next = closed ? 1 : 0;
  results::Field2D round = field;
  round.first.insert(round.first.begin(), field.first[last] - kFullTurn);
  round.first.push_back(field.first[next] + kFullTurn);
  round.value.clear();
  for (std::size_t j = 0; j < field.second.size(); ++j) {
    const auto row = field.value.begin() + static_cast<std::ptrdiff_t>(j * columns);
    round.value.push_back(row[static_cast<std::ptrdiff_t>(last)]);
    round.value.insert(round.value.end(), row, row + static_cast<std::ptrdiff_t>(columns));
    round.value.push_back(row[static_cast<std::ptrdiff_t>(next)]);
  }
  return round;
}

FieldSampler::FieldSampler(const results::Field2D& field) : field_(field) {}

FieldSampler::Corners FieldSampler::corners_of(double first, double second) const {
  const CellWeights column = find_place(field_.first, first), row = find_place(field_.second, second);
  const std::size_t width = field_.first.size(), corner = row.below * width + column.below;
  return {{field_.value[corner], field_.value[corner + 1], field_.value[corner + width],
           field_.value[corner + width + 1]},
          {(1 - column.weight) * (1 - row.weight), column.weight * (1 - row.weight),
           (1 - column.weight) * row.weight, column.weight * row.weight}};
}

double FieldSampler::at(double first, double second) const {
  return mean_of(corners_of(first, second));
}

double FieldSampler::at_outside_tools(double first, double second) const {
  Corners corners = corners_of(first, second);
  double outside = 0;
  for (std::size_t k = 0; k < 4; ++k)
    if (!results::is_inside_tool(corners.values[k])) outside += corners.weights[k];
  if (outside <= 0) return results::inside_tool();
  for (std::size_t k = 0; k < 4; ++k)
    corners.weights[k] = results::is_inside_tool(corners.values[k]) ? 0 : corners.weights[k] / outside;
  return mean_of(corners);
}

double FieldSampler::mean_of(const Corners& corners) {
  double sum = 0, weight = 0, unvalued = 0, tool = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double value = corners.values[k], part = corners.weights[k];
    if (results::is_unvalued_powder(value)) unvalued += part;
    if (results::is_inside_tool(value)) tool += part;
    if (!std::isfinite(value)) continue;
    sum += part * value;
    weight += part;
  }
  // The kind of place with the largest weight counts: places end half-way between nodes, rounded at corners.
  const double empty = 1 - weight - unvalued - tool;
  if (weight + unvalued >= 0.5 || weight + unvalued > std::max(tool, empty))
    return weight >= unvalued ? sum / weight : results::unvalued_powder();
  return tool > empty ? results::inside_tool() : std::nan("");
}

}  // namespace diefill::render
