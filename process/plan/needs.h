// What a scene needs whatever its setting, and why: read off the CAD, the powder and the steps.
#pragma once

#include <string>
#include <vector>

#include "process/plan/symmetry_plane.h"
#include "process/powder/law_terms.h"
#include "process/tooling/tooling.h"

namespace diefill::process::plan {

/// Least E~ over the largest pressure: keeps mean overlaps below 0.7 % of d (engine/STABILITY.md, stiffness).
inline constexpr double kModulusOverPressure = 3000;
/// Beyond this gamma_n / R damping only shortens the step (engine/STABILITY.md, damping).
inline constexpr double kMaxDamping = 3e6;

/// Facts about one scene. SI units.
struct Needs {
  geometry::Cavity cavity;                             ///< Tooling::all_cavities()
  double grain_diameter = 0, calibrated_diameter = 0;  ///< m
  double coarsest_grain = 0;                           ///< m, a third of the narrowest width; 0: no cavity
  double effective_width = 0;               ///< m, narrowest width less 1.4 (d - calibrated d); 0: no cavity
  double time_step = 0, critical_step = 0;  ///< s
  double wedged_step = 0;                   ///< s, wedged_time_step()
  double impact_speed = 0;                  ///< m/s
  double weight_pressure = 0;               ///< Pa, of the powder's own weight at the deepest place, at most
  double piston_pressure = 0;               ///< Pa, of the hardest pressing force-controlled tool; 0: none
  double modulus = 0;                       ///< Pa, E~ of the powder
  double least_modulus = 0;                 ///< Pa; 0: nothing presses on the powder
  double damping_over_radius = 0;           ///< Pa s/m
  double fill_height = 0;                   ///< m
  std::vector<SymmetryPlane> planes;
  LawTerms laws;
};

/// What the scene needs. `tooling` has its wall spheres. Throws SceneError as the run would.
Needs needs_of(const Scene& scene, const Tooling& tooling);

/// The same as statements for people, one per line, each with its reason.
std::vector<std::string> description(const Needs& needs, const Scene& scene, const Tooling& tooling);

/// m^2, area of the tool's surface that faces along `direction` (a unit vector), seen from there.
double facing_area(const geometry::Mesh& mesh, const Eigen::Vector3d& direction);

}  // namespace diefill::process::plan
