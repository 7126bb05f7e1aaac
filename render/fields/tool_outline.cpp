#include "render/fields/tool_outline.h"

#include <array>

namespace diefill::render {
namespace {

constexpr double kMillimetre = 1e-3;

// The piece of the plane in a triangle. A corner on the plane counts as above it: every mesh edge is then cut
// once or not at all, and outlines stay closed. Lines of one tool run the same way round.
Outline cut_triangle(const std::array<Eigen::Vector3d, 3>& corner, const results::SectionPlane& plane) {
  Outline line;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d &from = corner[k], &to = corner[(k + 1) % 3];
    const double height = (from - plane.origin).dot(plane.normal),
                 next = (to - plane.origin).dot(plane.normal);
    if ((height >= 0) == (next >= 0)) continue;
    const Eigen::Vector3d place = from + height / (height - next) * (to - from) - plane.origin;
    const Eigen::Vector2d point(place.dot(plane.first_axis), place.dot(plane.second_axis));
    line.insert(height >= 0 ? line.begin() : line.end(), point / kMillimetre);
  }
  return line;
}

}  // namespace

std::vector<Outline> tool_outlines(const std::vector<results::ToolState>& tools,
                                   const results::SectionPlane& plane) {
  std::vector<Outline> outlines;
  for (const auto& tool : tools)
    for (const auto& triangle : tool.triangles) {
      const auto corner = [&](int n) { return tool.vertices[static_cast<std::size_t>(triangle[n])]; };
      Outline line = cut_triangle({corner(0), corner(1), corner(2)}, plane);
      if (line.size() == 2) outlines.push_back(std::move(line));
    }
  return outlines;
}

}  // namespace diefill::render
