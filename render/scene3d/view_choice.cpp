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
constexpr double kFrame = 1.06;       // air around what is framed

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

// The cavities, widened so that their walls show, with powder and a shoe beside them.
Box cavity_region(const results::FillResult& result, const Box& cavity) {
  const Eigen::Vector3d size = result.cavity.upper_corner - result.cavity.lower_corner;
  const double width = std::max(size.x(), size.y());  // of one cavity: several are not to be seen from afar
  Box region = cavity;
  region.extend(cavity.min() - Eigen::Vector3d(kSideRoom * width, 0, 0.12 * width));
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

}  // namespace

ViewAxes view_axes(const ViewChoice& view) {
  const double turn = view.azimuth, tilt = view.elevation;
  const Eigen::Vector3d right(std::cos(turn), std::sin(turn), 0);
  const Eigen::Vector3d to_eye(std::sin(turn) * std::cos(tilt), -std::cos(turn) * std::cos(tilt),
                               std::sin(tilt));
  return {right, to_eye.cross(right), to_eye};
}

ViewChoice choose_view(const results::FillResult& result, double aspect, const Camera& camera) {
  ViewChoice view;
  view.elevation = camera.elevation;
  view.azimuth = camera.azimuth;
  const Box cavities = cavities_of(result);
  Box region;
  if (!cavities.isEmpty()) {
    const auto& cavity = result.cavity;
    view.cut_y =
        cavity.is_ring ? cavity.axis_origin.y() : 0.5 * (cavity.lower_corner + cavity.upper_corner).y();
    region = cavity_region(result, cavities);
  } else {
    region = powder_box(result.powder);
    if (region.isEmpty())
      for (const auto& tool : result.tools) region.extend(tool_box(tool));
    if (region.isEmpty()) {
      view.empty = true;
      return view;
    }
    view.cut_y = region.center().y();
  }
  if (camera != Camera{}) {
    frame_box(view, region, aspect);
    return view;
  }
  // In the picture, up is z lifted by the view's tilt: a point behind the cut appears higher by its depth's
  // sine.
  const double depth = std::max(0.0, region.max().y() - view.cut_y);
  const double low = region.min().z() * std::cos(camera.elevation);
  const double high = region.max().z() * std::cos(camera.elevation) + depth * std::sin(camera.elevation);
  const double needed_width = kFrame * region.sizes().x(), needed_height = kFrame * (high - low);
  view.width = std::max({needed_width, needed_height * aspect, 1e-6});
  view.height = view.width / aspect;
  view.target = {region.center().x(), view.cut_y, 0.5 * (low + high) / std::cos(camera.elevation)};
  return view;
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
