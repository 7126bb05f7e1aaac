// The space between two neighbouring solids: how wide it is where their surfaces face each other.
#pragma once

#include <functional>

#include "geometry/solid/solid_query.h"

namespace diefill::geometry {

/// Width of the space between two solids, m, and where.
struct Gap {
  bool found = false;  ///< false: nowhere do they face each other within reach
  double narrowest = 0;
  double widest = 0;                                       ///< within reach
  Eigen::Vector3d widest_place = Eigen::Vector3d::Zero();  ///< halfway between the surfaces
};

/// Whether to skip a point (m) on the surface of one solid, given the place halfway to the other; called from
/// several threads at once.
using SkipPoint = std::function<bool(const Eigen::Vector3d& point, const Eigen::Vector3d& halfway)>;

/// Samples the surface of `one` on points at most `spacing` (m) apart and measures, along their normals, how
/// far `other` is where it faces them within 30 degrees and at most `reach` (m) away. Skips points where
/// `skip` returns true, such as the inside of a cavity; empty: skips none. Solids may overlap; there the
/// width counts as 0.
Gap measure_gap(const SolidQuery& one, const SolidQuery& other, double reach, double spacing,
                const SkipPoint& skip);

}  // namespace diefill::geometry
