// Diagnosis of tools before a run: gaps, overlaps and symmetry.
#pragma once

#include <string>
#include <vector>

#include "geometry/solid/gaps.h"
#include "geometry/solid/symmetry.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// Two neighbouring tools as they stand at the start.
struct PairDiagnosis {
  std::string one, other;  ///< names
  double overlap = 0;      ///< m, how deep one reaches into the other
  Eigen::Vector3d overlap_place = Eigen::Vector3d::Zero();
  geometry::Gap gap;                ///< outside the cavity
  bool powder_enters = false;       ///< a sphere of the model's grains fits into the gap
  bool real_powder_enters = false;  ///< one of the powder before coarse graining does
  std::string description;          ///< one line
};

struct Diagnosis {
  std::vector<geometry::Symmetry> symmetry;  ///< one a tool
  std::vector<PairDiagnosis> pairs;          ///< those that face each other or overlap
};

/// Looks at all tools and pairs of them. `sphere_radius` (m) is that of the model grains' spheres.
Diagnosis diagnose(const Scene& scene, const Tooling& tooling, double sphere_radius);

}  // namespace diefill::process
