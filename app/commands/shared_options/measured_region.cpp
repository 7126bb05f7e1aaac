#include "app/commands/shared_options/measured_region.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "app/options/quantities.h"
#include "process/input/scene_error.h"
#include "process/measure/fields/averaging_width.h"

namespace diefill::app {
namespace {

using Box = Eigen::AlignedBox3d;

Box cavity_box(const results::FillResult& result) {
  Box box;
  if (result.cavity.volume > 0) box = Box(result.cavity.lower_corner, result.cavity.upper_corner);
  return box;
}

Box powder_box(const results::FillResult& result) {
  Box box;
  const Eigen::Vector3d radius = Eigen::Vector3d::Constant(0.5 * result.powder.largest_diameter());
  for (const auto& place : result.powder.position) box.extend(Box(place - radius, place + radius));
  return box;
}

/// The box around what a section may cut: without the shoe, which may be anywhere.
Box die_box(const results::FillResult& result) {
  Box box = cavity_box(result).merged(powder_box(result));
  for (const auto& tool : result.tools)
    if (tool.role == "die" || tool.role == "core" || tool.role == "punch")
      for (const auto& vertex : tool.vertices) box.extend(vertex);
  return box;
}

std::string range_text(const Box& box, Eigen::Index axis) {
  return process::number_text(1e3 * box.min()[axis]) + " to " + process::number_text(1e3 * box.max()[axis]);
}

}  // namespace

double largest_edge(const results::FillResult& result) {
  const Box cavity = cavity_box(result), box = cavity.isEmpty() ? powder_box(result) : cavity;
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

double averaging_width_of(const std::string& given, const std::vector<const results::FillResult*>& results) {
  double usual = 0, least = std::numeric_limits<double>::max(), most = 0;
  for (const auto* result : results) {
    const double diameter = result->powder.grain_diameter;
    usual = std::max(usual, process::usual_averaging_width(*result));
    least = std::min(least, process::least_averaging_width(diameter));
    most = std::max(most, process::largest_averaging_width(diameter, largest_edge(*result)));
  }
  if (given.empty()) return std::min(usual, most);
  return bounded_quantity("--averaging-width", given, process::Dimension::length,
                          {least, most, false, "from a tenth of a grain to the largest edge of the cavity"});
}

Eigen::Vector3d section_origin(const std::vector<std::string>& given, const results::FillResult& result) {
  Eigen::Vector3d origin = result.cavity.axis_origin;
  if (given.empty()) return origin;
  for (std::size_t axis = 0; axis < given.size(); ++axis)
    origin[static_cast<Eigen::Index>(axis)] = coordinate("--origin", given[axis]);
  constexpr double kRounding = 1e-9;  // m
  const Box box = die_box(result);
  if (box.isEmpty() || box.exteriorDistance(origin) <= kRounding) return origin;
  std::string found;
  for (const auto& text : given) found += (found.empty() ? "'" : " '") + text + "'";
  throw process::SceneError("--origin: found " + found + ", outside die and powder; allowed: x " +
                            range_text(box, 0) + " mm, y " + range_text(box, 1) + " mm, z " +
                            range_text(box, 2) + " mm");
}

}  // namespace diefill::app
