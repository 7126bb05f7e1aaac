// The maps, sections and profiles of a result, recomputed from its powder and solid fractions without
// simulation.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "process/results/fill_result.h"

namespace diefill::process {

/// What to look at when fields are measured.
struct FieldRequest {
  double averaging_width = 0;  ///< m, sigma of Eq. 2.27; 0: the larger of 0.5 mm and d/2
  std::vector<results::SectionPlane>
      sections;  ///< empty: the plane through the cavity's axis along azimuth 0
};

/// Name of the section that results have where none was requested.
inline constexpr const char* kDefaultSection = "along the shoe's motion";

/// Measures maps, sections and profiles of `result` again from its powder and solid fractions.
void measure_fields(results::FillResult& result, const FieldRequest& request, int azimuth_bins);

/// A plane with horizontal and vertical (or two horizontal) in-plane axes for a normal of any direction.
results::SectionPlane section_plane(const std::string& name, const Eigen::Vector3d& origin,
                                    const Eigen::Vector3d& normal);

}  // namespace diefill::process
