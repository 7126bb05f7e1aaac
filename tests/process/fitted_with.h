// What a powder file of tests was fitted with.
#pragma once

#include <string>

namespace diefill::process {

/// The table of a powder file, with an empty line around it.
inline const std::string kFittedWith = R"(
[powder.fitted_with]
grain_diameter = "1.88 mm"
reduced_modulus = "10 MPa"
wall_kind = "spheres"
wall_sphere_radius = "0.15 mm"
wall_spacing = 1.6

)";

}  // namespace diefill::process
