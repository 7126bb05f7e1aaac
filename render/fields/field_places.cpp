#include "render/fields/field_places.h"

#include <array>
#include <cmath>

#include "process/results/formatted.h"
#include "render/fields/field_sampler.h"
#include "render/fields/tool_outline.h"
#include "render/style/ticks.h"

namespace diefill::render {
namespace {

constexpr double kMillimetre = 1e-3;

bool has_size(const results::CavityState& cavity) {
  return ((cavity.upper_corner - cavity.lower_corner).array() > 0).all();
}

bool lies_in(const results::CavityState& cavity, const Eigen::Vector3d& point) {
  constexpr double kRounding = 1e-9;  // m
  if (((point - cavity.lower_corner).array() < -kRounding).any() ||
      ((point - cavity.upper_corner).array() > kRounding).any())
    return false;
  if (!cavity.is_ring) return true;
  const double radius = (point - cavity.axis_origin).head<2>().norm();
  return radius >= cavity.inner_radius - kRounding && radius <= cavity.outer_radius + kRounding;
}

std::string number(double value) {
  return results::formatted("%.4g", std::abs(value) < 5e-7 ? 0.0 : value);
}

/// "along (−0.71, 0.71, 0.00)" of an axis that is none of x, y and z; empty otherwise.
std::string oblique_label(const Eigen::Vector3d& axis) {
  if (axis.cwiseAbs().maxCoeff() > 1 - 1e-9) return {};
  std::string words;
  for (const double part : axis)
    words += (words.empty() ? "along (" : ", ") + tick_label(std::round(100 * part) / 100, 0.01);
  return words + ")";
}

/// Outlines of the tools seen from above, at this share of the cavity's height.
std::vector<Outline> outlines_at(const results::FillResult& result, double share) {
  results::SectionPlane plane;
  plane.normal = Eigen::Vector3d::UnitZ();
  plane.second_axis = Eigen::Vector3d::UnitY();
  plane.origin.z() = std::lerp(result.cavity.lower_corner.z(), result.cavity.upper_corner.z(), share);
  return tool_outlines(result.tools, plane);
}

}  // namespace

void add_section_places(FieldStyle& style, const results::FillResult& result,
                        const results::SectionPlane& plane) {
  style.outlines = tool_outlines(result.tools, plane);
  style.tool_levels = {style.outlines};
  style.first_label = oblique_label(plane.first_axis);
  style.second_label = oblique_label(plane.second_axis);
  std::vector<results::CavityState> cavities = result.other_cavities;
  cavities.push_back(result.cavity);
  std::erase_if(cavities, [](const auto& cavity) { return !has_size(cavity); });
  if (cavities.empty()) return;
  style.in_cavity = [cavities, plane](double first, double second) {
    const Eigen::Vector3d point =
        plane.origin + kMillimetre * (first * plane.first_axis + second * plane.second_axis);
    for (const auto& cavity : cavities)
      if (lies_in(cavity, point)) return true;
    return false;
  };
  if (plane.second_axis.z() > 0.999 && has_size(result.cavity))
    style.fill_plane = (result.cavity.upper_corner.z() - plane.origin.z()) / kMillimetre;
}

void add_map_places(FieldStyle& style, const results::FillResult& result, const results::Field2D& map) {
  const auto& cavity = result.cavity;
  if (!has_size(cavity)) return;
  if (map.second_name == "height") {
    const double depth = (cavity.upper_corner.z() - cavity.lower_corner.z()) / kMillimetre;
    style.fill_plane = depth;
    style.in_cavity = [depth](double, double height) { return height <= depth; };
    return;
  }
  style.outlines = outlines_at(result, 0.5);
  for (const double share : {0.05, 0.3, 0.5, 0.7, 0.95})
    style.tool_levels.push_back(outlines_at(result, share));
  style.in_cavity = [](double, double) { return true; };
}

std::string section_text(const results::SectionPlane& plane) {
  static const std::array<const char*, 3> names = {"x", "y", "z"};
  const double offset = plane.origin.dot(plane.normal) / kMillimetre;
  std::string words;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(plane.normal[axis]) > 1 - 1e-9)
      words = std::string("section ") + names[static_cast<std::size_t>(axis)] + " = " +
              number(plane.normal[axis] > 0 ? offset : -offset) + " mm";
  if (words.empty())
    words = "section with normal (" + number(plane.normal.x()) + ", " + number(plane.normal.y()) + ", " +
            number(plane.normal.z()) + "), " + number(offset) + " mm from the origin along it";
  if (!plane.name.empty() && plane.name != "section") words += " (" + plane.name + ")";
  return words;
}

}  // namespace diefill::render
