// Exact volumes of a ball cut by planes, and exact areas of a disc cut by a circle and two rays: what
// cell-wise solid volumes are made of.
#pragma once

namespace diefill::process {

/// Volume of the part of the unit ball with x >= a, y >= b and z >= c, exact for any a, b, c: above 1 the
/// volume is 0, below -1 the condition has no effect. Volume from the surface by the divergence theorem, the
/// spherical part of the surface from the theorem of Gauss and Bonnet.
double ball_beyond(double a, double b, double c);

/// Volume of the part of the unit ball with x >= a and y >= b.
double ball_beyond(double a, double b);

/// Volume of the part of the unit ball with x >= a: pi (1 - a)^2 (2 + a) / 3.
double ball_beyond(double a);

/// Area of a disc of radius `disc_radius` >= 0, centred at `distance` >= 0 from the origin in the direction
/// of polar angle 0, that lies within `circle_radius` of the origin and at polar angles from `from` to `to`
/// (rad, from <= to <= from + 2 pi). Exact; any unit of length.
double disc_in_sector(double distance, double disc_radius, double circle_radius, double from, double to);

}  // namespace diefill::process
