#include "tests/app/cad.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <sstream>

namespace diefill::app::cad {

namespace {

/// Corner k of an outline at height z, counting round.
Point corner(const Outline& outline, std::size_t k, double z) {
  const auto& point = outline[k % outline.size()];
  return {point[0], point[1], z};
}

void add_quadrangle(Part& part, const Point& a, const Point& b, const Point& c, const Point& d) {
  part.push_back({a, b, c});
  part.push_back({a, c, d});
}

/// Upright faces over an outline whose material is inside.
void add_sides(Part& part, const Outline& outline, double bottom, double top) {
  for (std::size_t k = 0; k < outline.size(); ++k)
    add_quadrangle(part, corner(outline, k, bottom), corner(outline, k + 1, bottom),
                   corner(outline, k + 1, top), corner(outline, k, top));
}

/// A convex face that looks up.
void add_lid(Part& part, const Outline& outline, double z) {
  for (std::size_t k = 1; k + 1 < outline.size(); ++k)
    part.push_back({corner(outline, 0, z), corner(outline, k, z), corner(outline, k + 1, z)});
}

/// The face between two outlines that looks up.
void add_frame(Part& part, const Outline& outer, const Outline& inner, double z) {
  for (std::size_t k = 0; k < outer.size(); ++k)
    add_quadrangle(part, corner(outer, k, z), corner(outer, k + 1, z), corner(inner, k + 1, z),
                   corner(inner, k, z));
}

/// Adds the faces of `other` looking the other way.
void add_turned(Part& part, const Part& other) {
  const Part turned = inside_out(other);
  part.insert(part.end(), turned.begin(), turned.end());
}

template <class Value>
void append(std::string& bytes, Value value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

}  // namespace

Outline rectangle(double lower_x, double upper_x, double lower_y, double upper_y) {
  return {{lower_x, lower_y}, {upper_x, lower_y}, {upper_x, upper_y}, {lower_x, upper_y}};
}

Outline circle(double radius, int corners) {
  Outline outline;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

Part prism(const Outline& outline, double bottom, double top) {
  Part part, underside;
  add_sides(part, outline, bottom, top);
  add_lid(part, outline, top);
  add_lid(underside, outline, bottom);
  add_turned(part, underside);
  return part;
}

Part block_with_pocket(const Outline& outer, const Outline& inner, double bottom, double floor, double top) {
  Part part, turned;
  add_sides(part, outer, bottom, top);
  add_frame(part, outer, inner, top);
  add_lid(part, inner, floor);
  add_sides(turned, inner, floor, top);
  add_lid(turned, outer, bottom);
  add_turned(part, turned);
  return part;
}

Part tube(const Outline& outer, const Outline& inner, double bottom, double top) {
  Part part, turned;
  add_sides(part, outer, bottom, top);
  add_frame(part, outer, inner, top);
  add_sides(turned, inner, bottom, top);
  add_frame(turned, outer, inner, bottom);
  add_turned(part, turned);
  return part;
}

Part block_with_groove(const std::array<Outline, 3>& outer_middle_core, double bottom, double floor,
                       double top) {
  const auto& [outer, middle, core] = outer_middle_core;
  Part part, turned;
  add_sides(part, outer, bottom, top);
  add_frame(part, outer, middle, top);
  add_frame(part, middle, core, floor);
  add_sides(part, core, floor, top);
  add_lid(part, core, top);
  add_sides(turned, middle, floor, top);
  add_lid(turned, outer, bottom);
  add_turned(part, turned);
  return part;
}

Part inside_out(Part part) {
  for (Triangle& triangle : part) std::swap(triangle[1], triangle[2]);
  return part;
}

Part moved(Part part, const Point& by) {
  for (Triangle& triangle : part)
    for (Point& point : triangle)
      for (std::size_t axis = 0; axis < 3; ++axis) point[axis] += by[axis];
  return part;
}

Part joined(Part one, const Part& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

std::string binary_stl(const Part& part) {
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(part.size()));
  for (const Triangle& triangle : part) {
    for (int k = 0; k < 3; ++k) append(bytes, 0.0F);  // the normal, which readers make themselves
    for (const Point& point : triangle)
      for (const double value : point) append(bytes, static_cast<float>(value));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string text_stl(const Part& part) {
  std::ostringstream text;
  text << "solid part\n";
  for (const Triangle& triangle : part) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const Point& point : triangle)
      text << "vertex " << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
    text << "endloop\nendfacet\n";
  }
  text << "endsolid part\n";
  return text.str();
}

}  // namespace diefill::app::cad
