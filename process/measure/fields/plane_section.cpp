#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "process/measure/fields/gaussian_field.h"
#include "process/measure/fields/plane_sample.h"
#include "process/measure/fields/powder_places.h"
#include "process/measure/measure.h"
#include "process/measure/tool_solids.h"
#include "process/results/places_without_value.h"

namespace diefill::process {
namespace {

constexpr double kMillimetre = 1e-3;
constexpr double kMaxNodes = 400;  // along either axis

/// A rectangle in the plane, m from its origin.
struct Extent {
  Eigen::Array2d lower = Eigen::Array2d::Constant(std::numeric_limits<double>::max());
  Eigen::Array2d upper = Eigen::Array2d::Constant(std::numeric_limits<double>::lowest());
  bool empty() const { return (lower > upper).any(); }
};

Eigen::Array2d in_plane(const results::SectionPlane& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d from_origin = point - plane.origin;
  return {from_origin.dot(plane.first_axis), from_origin.dot(plane.second_axis)};
}

/// Of the grains within `thickness` of the plane, those in the cavity or all.
Extent extent_of_grains(const results::PowderState& powder, const results::GrainSolidFraction& fraction,
                        const results::SectionPlane& plane, double thickness, bool only_cavity) {
  Extent extent;
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    if (only_cavity && fraction.in_cavity[k] == 0) continue;
    if (std::abs((powder.position[k] - plane.origin).dot(plane.normal)) > thickness) continue;
    const Eigen::Array2d place = in_plane(plane, powder.position[k]);
    extent.lower = extent.lower.min(place);
    extent.upper = extent.upper.max(place);
  }
  return extent;
}

/// Axes along the laboratory's go by its names.
std::string axis_name(const Eigen::Vector3d& axis, const char* otherwise) {
  const std::array<const char*, 3> names = {"x", "y", "z"};
  for (int n = 0; n < 3; ++n)
    if (axis[n] > 1 - 1e-9) return names[n];
  return otherwise;
}

std::vector<double> nodes(double lower, double upper, double step) {
  const int intervals = static_cast<int>(std::ceil((upper - lower) / step));
  std::vector<double> places;
  for (int n = 0; n <= intervals; ++n) places.push_back((lower + n * step) / kMillimetre);
  return places;
}

/// Whether `point` is inside a tool, or in a clearance between two that is narrower than `room` (m).
bool no_room_at(const std::vector<geometry::SolidQuery>& solids, const Eigen::Vector3d& point, double room) {
  double nearest = std::numeric_limits<double>::max(), next = nearest;
  for (const auto& solid : solids) {
    const double distance = solid.signed_distance(point);
    if (distance < 0) return true;
    next = std::min(next, std::max(nearest, distance));
    nearest = std::min(nearest, distance);
  }
  return nearest + next < room;
}

Eigen::Vector3d point_of(const results::SectionPlane& plane, double first, double second) {
  return plane.origin + kMillimetre * (first * plane.first_axis + second * plane.second_axis);
}

/// 1 for the nodes that the powder's outline holds, whatever tools are there.
std::vector<std::uint8_t> powder_nodes(const results::PowderState& powder, const results::SectionPlane& plane,
                                       const results::Field2D& grid, double step,
                                       const std::function<bool(const Eigen::Vector3d&)>& is_tool) {
  const PowderPlaces places(powder);
  std::vector<std::uint8_t> near;
  for (const double second : grid.second)
    for (const double first : grid.first) near.push_back(places.near(point_of(plane, first, second)) ? 1 : 0);
  erode_edges(
      near, {grid.first.size(), grid.second.size(), step, step, false}, outline_depth(places),
      [&](std::size_t i, std::size_t j) { return is_tool(point_of(plane, grid.first[i], grid.second[j])); });
  return near;
}

/// A field without nodes on the plane.
results::SectionField empty_section(const results::SectionPlane& plane, double averaging_width) {
  return {plane,
          {"solid fraction",
           axis_name(plane.first_axis, "first axis"),
           "mm",
           axis_name(plane.second_axis, "second axis"),
           "mm",
           {},
           {},
           {},
           averaging_width}};
}

/// The rectangle of a section: the powder near the plane, that in the cavity where there is some, and two
/// grains more on each side. Empty where no powder is near.
Extent extent_of_section(const results::PowderState& powder, const results::GrainSolidFraction& fraction,
                         const results::SectionPlane& plane, double averaging_width) {
  const double thickness = std::max(powder.grain_diameter, 2 * averaging_width);
  Extent extent = extent_of_grains(powder, fraction, plane, thickness, true);
  if (extent.empty()) extent = extent_of_grains(powder, fraction, plane, thickness, false);
  if (extent.empty()) return extent;
  extent.lower -= 2 * powder.grain_diameter;
  extent.upper += 2 * powder.grain_diameter;
  return extent;
}

}  // namespace

results::SectionField sample_plane(const results::PowderState& powder,
                                   const results::GrainSolidFraction& fraction,
                                   const std::vector<results::ToolState>& tools,
                                   const results::SectionPlane& plane, double averaging_width,
                                   const PlaneValue& value_at) {
  const std::vector<geometry::SolidQuery> solids = solids_of(tools);
  results::SectionField section = empty_section(plane, averaging_width);
  const Extent extent = extent_of_section(powder, fraction, plane, averaging_width);
  if (extent.empty()) return section;
  // Finer than the field itself asks for: walls are drawn half-way between nodes.
  const double step = std::max(0.2 * averaging_width, (extent.upper - extent.lower).maxCoeff() / kMaxNodes);
  results::Field2D& grid = section.field;
  grid.first = nodes(extent.lower.x(), extent.upper.x(), step);
  grid.second = nodes(extent.lower.y(), extent.upper.y(), step);
  const auto no_room = [&](const Eigen::Vector3d& point) {
    return no_room_at(solids, point, 0.5 * powder.sphere_radius);
  };
  const std::vector<std::uint8_t> is_powder = powder_nodes(powder, plane, grid, step, no_room);
  for (const double second : grid.second)
    for (const double first : grid.first) {
      const Eigen::Vector3d point = point_of(plane, first, second);
      double value = std::numeric_limits<double>::quiet_NaN();
      if (no_room(point))
        value = results::inside_tool();
      else if (is_powder[grid.value.size()] != 0) {
        value = value_at(point);
        if (std::isnan(value)) value = results::unvalued_powder();
      }
      grid.value.push_back(value);
    }
  return section;
}

results::SectionField plane_section(const results::PowderState& powder,
                                    const results::GrainSolidFraction& fraction,
                                    const std::vector<results::ToolState>& tools,
                                    const results::SectionPlane& plane, double averaging_width) {
  const GaussianField field(powder, fraction, averaging_width);
  return sample_plane(powder, fraction, tools, plane, averaging_width,
                      [&field](const Eigen::Vector3d& point) { return field.mean_at(point); });
}

}  // namespace diefill::process
