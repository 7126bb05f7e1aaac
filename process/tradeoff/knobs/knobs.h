// The registered knobs, a file each.
#pragma once

#include "process/tradeoff/knob.h"

namespace diefill::process {

/// Model grain diameter d; a value may name the rule of coarse graining, "1.88 mm by bierwisch".
Knob grain_diameter_knob();
/// Time step as a fraction of the critical one.
Knob time_step_knob();
/// E~, the reduced modulus.
Knob reduced_modulus_knob();
/// Grain model A to D (Bierwisch 2009, section 2.2).
Knob grain_model_knob();
/// Radius of the wall spheres.
Knob wall_sphere_radius_knob();
/// Distance of wall spheres over their radius.
Knob wall_spacing_knob();
/// Height of the powder in the shoe (Bierwisch 2009, section 4.1.6).
Knob powder_height_knob();
/// Length of a periodic slice, the pour with it.
Knob slice_length_knob();
/// Skin of the neighbour lists.
Knob skin_knob();

}  // namespace diefill::process
