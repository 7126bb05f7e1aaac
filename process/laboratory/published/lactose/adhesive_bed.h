// Beds of fine adhesive powder (Kottlan 2018): the contact parameters of a powder from Young's modulus, a
// reference overlap and ratios, and the periodic bed of adhesive_bed.toml that is packed and pressed.
#pragma once

#include <string>
#include <vector>

#include "process/laboratory/published/scene_experiment.h"
#include "process/results/fill_result.h"

namespace diefill::process::laboratory {

/// Parameters of single spheres as the source names them. Defaults: values that calibration held constant.
struct AdhesivePowder {
  double hamaker = 0;          ///< J, A_H
  double unloading_ratio = 2;  ///< f_1 = k_2 / k_1
  double friction = 0;         ///< mu_s
  double young = 0;            ///< Pa, Y
  double depth = 0;            ///< phi_f
  double radius = 0;           ///< m
  double rolling = 0;          ///< mu_roll
  double cohesion_ratio = 0;   ///< f_2 = k_c / k_1
  double tangential_ratio = 0.6, dynamic_ratio = 1, restitution = 0.65,
         damping_ratio = 0.6;               ///< f_3, f_4, e, f_5
  const char* rolling_law = "elastic CDT";  ///< as `contact.rolling` has it
  double reference_overlap = 0.01;          ///< delta', over the radius: not published

  double diameter() const { return 2 * radius; }
  double mass() const;  ///< kg, 1545 kg/m^3
  /// N/m, k_1 = 4/3 Y r sqrt(delta') (Kottlan 2018, Eq. 3).
  double loading_stiffness() const;
  /// N s/m, gamma_n of a pair (Eqs. 7 and 8 with the reduced mass).
  double damping() const;
};

/// The calibrated sets (Tables 11 and 14).
AdhesivePowder lh100();
AdhesivePowder lh220();

/// How the bed comes about (section 1 of the source's study of packing).
enum class Packing {
  clusters,  ///< attraction from afar; spheres are stopped in flight and stick before they fall
  motion,    ///< spheres stick on contact while they still fly, before they fall
  slow,      ///< stick on contact while they fall, no faster than in air
  plain,     ///< stick on contact while they fall
  free       ///< no attraction
};

/// Grains and laws of the powder in any scene of such powder. Without attraction the law stays, with none of
/// its force, so that its keys replace those of the scene.
std::string powder_lines(const AdhesivePowder& powder, Packing packing);
/// Friction of that powder with this coefficient, as `contact` has it.
std::string friction_part(const AdhesivePowder& powder, double friction);

/// A bed, in grain diameters: its width, and its depth once it is cut flat, at a solid fraction of 0.5.
struct AdhesiveBed {
  double width = 6, fill = 10;
  Packing packing = Packing::clusters;
};

/// What presses the bed.
struct Loads {
  std::vector<double> stresses;  ///< Pa, one after the other
  double speed = 0.03;           ///< m/s, limit
  double pause = 0.08;           ///< sqrt(d / g), for which each is held
  double interval = 0.004;       ///< sqrt(d / g), between rows of the probe
};

/// d, of the plate's lower face over the floor before it moves.
double plate_height(const AdhesiveBed& bed);
/// Wall spheres, which measures see in place of the tools' surfaces, of tools down to `width` (m) for which
/// the usual ones are too large; nothing for others.
std::string fine_wall_lines(const AdhesivePowder& powder, double width);
/// Puts powder and bed into adhesive_bed.toml; times of falling are in proportion to sqrt(d / g).
std::string packed_bed_lines(const AdhesivePowder& powder, const AdhesiveBed& bed);
/// The same with the plate that presses.
std::string pressed_bed_lines(const AdhesivePowder& powder, const AdhesiveBed& bed, const Loads& loads);
/// Behind packed_bed_lines: the plate does not move.
std::string unpressed_lines();

/// m, of the highest layer of spheres of the bed: the mean height of the highest hundredth, at least five.
/// Spheres that stick to a plate more than 2 d above the bed are left out.
double surface_of(const results::PowderState& powder);

}  // namespace diefill::process::laboratory
