// Small CAD parts for tests, made of prisms, and the bytes of their STL files. Lengths in mm.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace diefill::app::cad {

using Point = std::array<double, 3>;
using Triangle = std::array<Point, 3>;
using Part = std::vector<Triangle>;  ///< counter-clockwise seen from outside

/// Corners of an outline in the x-y plane, counter-clockwise seen from above.
using Outline = std::vector<std::array<double, 2>>;

Outline rectangle(double lower_x, double upper_x, double lower_y, double upper_y);
/// Corners on a circle about the origin.
Outline circle(double radius, int corners);

/// A prism over `outline` from `bottom` to `top`.
Part prism(const Outline& outline, double bottom, double top);
/// A prism over `outer` with a pocket over `inner` (as many corners) from `floor` up to the top.
Part block_with_pocket(const Outline& outer, const Outline& inner, double bottom, double floor, double top);
/// The space between two outlines of as many corners: a shoe without lid and bottom.
Part tube(const Outline& outer, const Outline& inner, double bottom, double top);
/// A block whose pocket has a core in its middle, up to the top: one part that encloses a ring.
Part block_with_groove(const std::array<Outline, 3>& outer_middle_core, double bottom, double floor,
                       double top);

Part inside_out(Part part);
Part moved(Part part, const Point& by);
/// Both as one part.
Part joined(Part one, const Part& other);

std::string binary_stl(const Part& part);
std::string text_stl(const Part& part);

}  // namespace diefill::app::cad
