#include "render/scene3d/view_choice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace diefill::render {
namespace {

using Box = Eigen::AlignedBox3d;

constexpr double kSideRoom = 0.25;    // of the cavity's width, around the cavity
constexpr double kNearPowder = 0.75;  // of the cavity's width: powder this far beside it is framed
constexpr double kNearShoe = 1.0;     // of the cavity's width: a shoe this near is framed
constexpr double kWidestView = 2.6;   // of the cavity's width: never further away than this
constexpr double kFloorRoom = 0.12;   // of the cavity's width, below the cavity
constexpr double kFrame = 1.06;       // air around what is framed

// Of a shoe that crosses the cavity, in widths of the cavity.
constexpr double kLeastTravel = 0.5;    // below it, the shoe stays where it is
constexpr double kPassageRoom = 0.4;    // beside the cavity
constexpr double kPassageHeight = 0.5;  // above the cavity, at most: powder that flows is low in the shoe

Box powder_box(const results::PowderState& powder) {
  Box box;
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * powder.largest_diameter());
  for (const auto& position : powder.position) box.extend(Box(position - half, position + half));
  return box;
}

Box tool_box(const results::ToolState& tool) {
  Box box;
  for (const auto& vertex : tool.vertices) box.extend(vertex);
  return box;
}

/// All cavities with a size, from the largest to the smallest coordinates.
Box cavities_of(const results::FillResult& result) {
  Box all;
  const auto add = [&](const results::CavityState& cavity) {
    const Box box(cavity.lower_corner, cavity.upper_corner);
    if (box.sizes().minCoeff() > 0) all.extend(box);
  };
  add(result.cavity);
  if (all.isEmpty()) return all;
  for (const auto& cavity : result.other_cavities) add(cavity);
  return all;
}

/// Of one cavity: the width over several would put the view too far away.
double width_of(const results::CavityState& cavity) {
  return (cavity.upper_corner - cavity.lower_corner).head<2>().maxCoeff();
}

// The cavities, widened so that their walls show, with powder and a shoe beside them.
Box cavity_region(const results::FillResult& result, const Box& cavity) {
  const double width = width_of(result.cavity);
  Box region = cavity;
  region.extend(cavity.min() - Eigen::Vector3d(kSideRoom * width, 0, kFloorRoom * width));
  region.extend(cavity.max() + Eigen::Vector3d(kSideRoom * width, 0, 0.05 * width));
  Box near(cavity.min() - Eigen::Vector3d::Constant(kNearPowder * width),
           cavity.max() + Eigen::Vector3d::Constant(kNearPowder * width));
  near.max().z() = cavity.max().z() + 2 * width;
  for (const auto& position : result.powder.position)
    if (near.contains(position)) region.extend(position);
  for (const auto& tool : result.tools) {
    if (tool.role != "shoe" || tool.vertices.empty()) continue;
    const Box shoe = tool_box(tool);
    const double gap = std::max(shoe.min().x() - cavity.max().x(), cavity.min().x() - shoe.max().x());
    if (gap < kNearShoe * width) region.extend(shoe);
  }
  const double centre = cavity.center().x(),
               half = std::max(0.5 * kWidestView * width, (0.5 + kSideRoom) * cavity.sizes().x());
  region.min().x() = std::max(region.min().x(), centre - half);
  region.max().x() = std::min(region.max().x(), centre + half);
  // What lies far behind the cavity may leave the picture; drawn tilted, it would push the cavity out of it.
  region.max().y() = std::min(region.max().y(), cavity.max().y() + kSideRoom * width);
  region.max().z() = std::min(region.max().z(), cavity.max().z() + 1.2 * width);
  return region;
}

/// m, horizontally, over all places that a tool takes in the instants of a run and at its end.
double travel_of(const results::FillResult& result, std::size_t tool) {
  const Eigen::Vector3d end = tool_box(result.tools[tool]).center();
  Box places(end);
  for (const auto& instant : result.instants) {
    const Eigen::Vector4d& turn = instant.tool_orientation.at(tool);
    places.extend(Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3]) * end +
                  instant.tool_displacement.at(tool));
  }
  return places.sizes().head<2>().norm();
}

// The cavities, with room for a shoe that crosses them; empty where none does.
Box passage_region(const results::FillResult& result, const Box& cavity) {
  const double width = width_of(result.cavity);
  double height = 0;  // m, of the shoe above the cavity
  for (std::size_t n = 0; n < result.tools.size(); ++n) {
    const auto& tool = result.tools[n];
    if (tool.role != "shoe" || tool.vertices.empty() || travel_of(result, n) < kLeastTravel * width) continue;
    height = std::max(height, tool_box(tool).max().z() - cavity.max().z());
  }
  if (height <= 0) return {};
  const Eigen::Vector3d beside(kPassageRoom * width, kSideRoom * width, 0);
  const Eigen::Vector3d below(0, 0, kFloorRoom * width),
      above(0, 0, std::min(height, kPassageHeight * width));
  return Box(cavity.min() - beside - below, cavity.max() + beside + above);
}

double cut_through(const results::CavityState& cavity) {
  return cavity.is_ring ? cavity.axis_origin.y() : 0.5 * (cavity.lower_corner + cavity.upper_corner).y();
}

// Frames all corners of the box as the eye sees them.
void frame_box(ViewChoice& view, const Box& box, double aspect) {
  const ViewAxes axes = view_axes(view);
  Eigen::AlignedBox2d seen;
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3d corner = box.corner(static_cast<Box::CornerType>(n)) - box.center();
    seen.extend(Eigen::Vector2d(corner.dot(axes.right), corner.dot(axes.up)));
  }
  view.width = kFrame * std::max({seen.sizes().x(), seen.sizes().y() * aspect, 1e-6});
  view.height = view.width / aspect;
  view.target = box.center() + seen.center().x() * axes.right + seen.center().y() * axes.up;
}

ViewChoice seen_by(const Camera& camera) {
  ViewChoice view;
  view.elevation = camera.elevation;
  view.azimuth = camera.azimuth;
  return view;
}

/// Cuts at `cut_y` (m) and frames the region.
ViewChoice framed(const Box& region, double cut_y, double aspect, const Camera& camera) {
  ViewChoice view = seen_by(camera);
  view.cut_y = cut_y;
  if (camera != Camera{}) {
    frame_box(view, region, aspect);
    return view;
  }
  // In the picture, up is z lifted by the view's tilt: a point behind the cut appears higher by its depth's
  // sine.
  const double depth = std::max(0.0, region.max().y() - cut_y);
  const double low = region.min().z() * std::cos(camera.elevation);
  const double high = region.max().z() * std::cos(camera.elevation) + depth * std::sin(camera.elevation);
  const double needed_width = kFrame * region.sizes().x(), needed_height = kFrame * (high - low);
  view.width = std::max({needed_width, needed_height * aspect, 1e-6});
  view.height = view.width / aspect;
  view.target = {region.center().x(), cut_y, 0.5 * (low + high) / std::cos(camera.elevation)};
  return view;
}

}  // namespace

ViewAxes view_axes(const ViewChoice& view) {
  const double turn = view.azimuth, tilt = view.elevation;
  const Eigen::Vector3d right(std::cos(turn), std::sin(turn), 0);
  const Eigen::Vector3d to_eye(std::sin(turn) * std::cos(tilt), -std::cos(turn) * std::cos(tilt),
                               std::sin(tilt));
  return {right, to_eye.cross(right), to_eye};
}

ViewChoice choose_view(const results::FillResult& result, double aspect, const Camera& camera) {
  const Box cavities = cavities_of(result);
  if (!cavities.isEmpty())
    return framed(cavity_region(result, cavities), cut_through(result.cavity), aspect, camera);
  Box region = powder_box(result.powder);
  if (region.isEmpty())
    for (const auto& tool : result.tools) region.extend(tool_box(tool));
  if (!region.isEmpty()) return framed(region, region.center().y(), aspect, camera);
  ViewChoice nothing = seen_by(camera);
  nothing.empty = true;
  return nothing;
}

std::optional<ViewChoice> view_of_passage(const results::FillResult& result, double aspect,
                                          const Camera& camera) {
  const Box cavities = cavities_of(result);
  if (cavities.isEmpty()) return std::nullopt;
  const Box region = passage_region(result, cavities);
  if (region.isEmpty()) return std::nullopt;
  return framed(region, cut_through(result.cavity), aspect, camera);
}

ViewChoice united(const ViewChoice& one, const ViewChoice& other) {
  const ViewAxes axes = view_axes(one);
  const Eigen::Vector3d way = other.target - one.target;
  const Eigen::Vector2d middle(way.dot(axes.right), way.dot(axes.up));
  const Eigen::Vector2d half_one = 0.5 * Eigen::Vector2d(one.width, one.height),
                        half_other = 0.5 * Eigen::Vector2d(other.width, other.height);
  Eigen::AlignedBox2d seen(-half_one, half_one);
  seen.extend(Eigen::AlignedBox2d(middle - half_other, middle + half_other));
  const double aspect = one.width / one.height;
  ViewChoice view = one;
  view.width = std::max(seen.sizes().x(), seen.sizes().y() * aspect);
  view.height = view.width / aspect;
  view.target = one.target + seen.center().x() * axes.right + seen.center().y() * axes.up;
  return view;
}

}  // namespace diefill::render
