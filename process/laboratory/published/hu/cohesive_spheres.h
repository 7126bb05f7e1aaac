// The cohesive spheres of Hu 2024, chapters 5 and 6 (1000 kg/m^3, E = 10 MPa, nu = 0.3, restitution 0.1,
// friction 0.3), enlarged, as keys of a scene.
#pragma once

#include <string>
#include <vector>

namespace diefill::process::laboratory {

inline constexpr double kCohesiveDensity = 1000;  ///< kg/m^3, of the spheres

/// Original spheres of one size.
struct SphereClass {
  double diameter = 5e-4;  ///< m
  double share = 1;        ///< of their number
};

/// Defaults: the mono-disperse beds of section 5.2.
struct CohesiveSpheres {
  double enlargement = 4;        ///< l
  int method = 1;                ///< of chapters 5 and 6
  double surface_energy = 0.2;   ///< J/m^2 of one surface
  std::string rolling = "none";  ///< "none", "EPSD2" or "CDT"
  double rolling_friction = 0;   ///< mu_r
  double restitution = 0.1;
  double rolling_spring = 1;              ///< stiffness of EPSD2's spring over that of Hu 2024, Eq. 2.50
  std::string load = "corrected";         ///< F_N of JKR: "corrected", or Eq. 2.28 as "printed"
  std::string load_rule;                  ///< key load_rule of [contact]; empty: the usual one
  std::vector<SphereClass> sizes = {{}};  ///< ascending
};

/// m, enlarged: the largest sphere, and the sphere of mean mass.
double largest_diameter(const CohesiveSpheres& spheres);

/// Puts spheres, laws and scaling into sticky_bed.toml or heap.toml.
std::string cohesive_lines(const CohesiveSpheres& spheres);

}  // namespace diefill::process::laboratory
