// What a field's picture shows besides the field: scale, outlines, arrows, remarks.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "process/results/arrow_field.h"

namespace diefill::render {

/// A line on the picture, in the field's coordinates.
using Outline = std::vector<Eigen::Vector2d>;

/// A star at a place of the field, and what it means.
struct StarMark {
  Eigen::Vector2d place;
  std::string meaning;
};

/// A line through the places where the field has a value, and what it means.
struct LevelLine {
  double level = 0;
  std::string meaning;
};

struct FieldStyle {
  bool diverging = false;   ///< a difference: colours run from less (blue) over 0 (white) to more (red)
  bool mark_mean = false;   ///< an arrow at the scale and a remark give the mean of the nodes with powder
  std::string unit;         ///< of the values; empty: none
  std::string scale_label;  ///< of the colour scale; empty: the field's quantity
  /// Names of the axes where the field's own do not say their directions, as of oblique sections; empty: its
  /// own.
  std::string first_label, second_label;
  std::vector<Outline> outlines;  ///< cavity and tools
  /// Outlines of the tools in one plane or several; a tool is where all of them have one.
  std::vector<std::vector<Outline>> tool_levels;
  std::vector<results::PlaneArrow> arrows;  ///< drawn in black with a white edge
  double arrow_length = 0;  ///< value (in `unit`) of the arrow in the legend; 0: from the arrows
  std::string note;         ///< small print added at the foot, such as what was compared
  /// Whether a place (the field's coordinates) lies in a cavity: distinguishes an empty cavity from air.
  std::function<bool(double first, double second)> in_cavity;
  /// Second coordinate of the fill plane, marked by a line with its name; NaN: none.
  double fill_plane = std::numeric_limits<double>::quiet_NaN();
  std::vector<StarMark> stars;         ///< with a legend above the field
  std::vector<LevelLine> level_lines;  ///< the same
  double pixels = 1;                   ///< picture points a layout point: 2 doubles the resolution
};

}  // namespace diefill::render
