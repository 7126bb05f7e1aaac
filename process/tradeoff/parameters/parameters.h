// The registered parameters, a file each.
#pragma once

#include "process/tradeoff/parameter.h"

namespace diefill::process {

/// Model grain diameter d; a value may name the rule of coarse graining, "1.88 mm by bierwisch".
Parameter grain_diameter_parameter();
/// Time step as a fraction of the critical one.
Parameter time_step_parameter();
/// E~, the reduced modulus.
Parameter reduced_modulus_parameter();
/// Grain model A to D (Bierwisch 2009, section 2.2).
Parameter grain_model_parameter();
/// Radius of the wall spheres.
Parameter wall_sphere_radius_parameter();
/// Distance of wall spheres over their radius.
Parameter wall_spacing_parameter();
/// Height of the powder in the shoe (Bierwisch 2009, section 4.1.6).
Parameter powder_height_parameter();
/// Length of a periodic slice, the pour with it.
Parameter slice_length_parameter();
/// Skin of the neighbour lists.
Parameter skin_parameter();

}  // namespace diefill::process
