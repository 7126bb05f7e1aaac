// A filled ring made up by formulas, for pictures: plausible powder, tools, fields and profiles, no
// simulation.
#pragma once

#include <string>

#include "process/results/fill_result.h"

namespace diefill::render::test {

/// A tube of `sides` flat sides around a vertical axis, closed, from z lower to upper; inner_radius 0 gives a
/// rod.
results::ToolState make_tube(const std::string& role, double inner_radius, double outer_radius, double lower,
                             double upper, const Eigen::Vector2d& centre, int sides);

/// Solid fraction that the synthetic fields and grains have at an azimuth (deg) and a height (mm above the
/// floor).
double synthetic_fraction(double azimuth, double height);

/// A map over 0..355 deg and 0..20 mm; nodes above the powder surface (18 mm, 16 mm near 180 deg) are NaN.
results::Field2D make_map();

/// The section y = 0 through a ring of radii 8 and 12.46 mm; the core is NaN.
results::SectionField make_section();

/// Everything at once: ring of inner radius 8 mm, outer 12.46 mm, 20 mm deep, filled with model D grains
/// of 1.88 mm, and a shoe with powder beside it.
results::FillResult make_ring();

}  // namespace diefill::render::test
