// The powder tester (Kottlan 2018, sections 2.7.4 and 2.7.5): adhesive powder in a cylindrical cell with
// vanes on its floor, under a vaned head or a smooth disc that is pressed down and turned. Lengths of the
// cell in grain diameters; its drawings are scaled by them.
#pragma once

#include <string>
#include <vector>

#include "process/laboratory/published/lactose/adhesive_bed.h"

namespace diefill::process::laboratory {

struct ShearCell {
  static constexpr double kRimGap = 0.15;  ///< d, between the rims of head or disc and cell, as drawn

  int bore = 10;            ///< d, as there are drawings for: 10 or 16
  int grains = 900;         ///< that fill it about as high as it is wide
  double rim_speed = 0.02;  ///< m/s

  /// d, of the head's vanes: 3 in the cell of 16 d, less in the other, whose lengths are all 5/8 of those.
  double vane_depth() const { return 3.0 * bore / 16; }
};

/// That of the experiments of a size.
ShearCell shear_cell(LabSize size);

/// A cell and what is in it.
struct FilledCell {
  AdhesivePowder powder;
  ShearCell cell;

  double radius() const;  ///< m
  double area() const;    ///< m^2
  /// N, of a tool that presses with a stress (Pa).
  double force(double stress) const { return stress * area(); }
  /// Pa, tau of a torque (N m): 3 T / (2 pi R^3), the same stress all over the disc.
  double shear_stress(double torque) const;
  double turn_speed() const;                ///< rad/s
  double angle(double rim_travel) const;    ///< rad, of a displacement (d) of the rim
  double seconds(double rim_travel) const;  ///< for such a displacement
};

/// Powder, cell and `tool` of a scene, which stands over the loose powder with whatever reaches `below` (d)
/// under its face, and the travel of the piston `press` to near the floor.
std::string filled_cell_lines(const FilledCell& filled, const std::string& tool, const std::string& drawing,
                              double below);
/// "12 deg" and "3 rpm" in quotes.
std::string degrees(double radians);
std::string turns_a_minute(double speed);

/// Stresses on the tool over time, means over the intervals of its probe. Pa, s.
struct ShearCurve {
  std::vector<double> time, normal, shear;
};

/// Of the probe with the name of the tool. Shear is positive against turning about z.
ShearCurve shear_curve(const SeedResults& seed, const std::string& run, const std::string& tool,
                       const FilledCell& filled);

/// Mean stresses from one time to another (s); NaN where the curve has no row in between.
struct MeanStress {
  double normal, shear;
};
MeanStress mean_stress(const ShearCurve& curve, double from, double to);

/// The stretch of `length` s within these times in which the mean shear stress is highest.
MeanStress highest_stress(const ShearCurve& curve, double from, double to, double length);

/// s, when a tool's motions began and ended, in the order of the scene's steps.
struct Span {
  double start, end;
};
std::vector<Span> spans_of(const SeedResults& seed, const std::string& run, const std::string& tool);

}  // namespace diefill::process::laboratory
