// A powder before coarse graining: grain model, material and the grain sizes wanted.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/powder/grain_shape.h"
#include "engine/powder/size_classes.h"

namespace diefill::process {

/// Grain models of Bierwisch 2009, section 2.2: A sphere without rotation, B rotating sphere, C six
/// overlapping spheres on an octahedron, D seven touching spheres; or a clump of the user's own.
enum class GrainModel { A, B, C, D, clump };

struct PowderSpec;

/// d / R of a powder's grains: 2 for models A and B, 4 for C, 6 for D (Bierwisch 2009, Table 4.1); of a clump
/// the diameter of the sphere about its centre of mass that holds it over its smallest radius.
double diameter_over_radius(const PowderSpec& powder);

/// Powder as simulated at the reference grain size, before coarse graining. SI units. Defaults: Bierwisch
/// 2009, Table C.4.
struct PowderSpec {
  std::string name;   ///< preset or "custom"
  std::string label;  ///< what the scene calls it, `name` unless it says something else
  GrainModel model = GrainModel::D;
  std::shared_ptr<const engine::GrainShape> clump;  ///< of model "clump", at the reference size
  double sphere_radius = 7.84e-5;       ///< m, R at the reference size; of unequal spheres the smallest
  double grain_mass = 7.63e-8;          ///< kg at the reference size
  double reduced_modulus = 1e7;         ///< Pa, E~ = E / (1 - nu^2)
  double damping_over_radius = 1e6;     ///< Pa s/m, gamma_n / R
  double tangential_over_radius = 1e6;  ///< Pa, kappa_t / R
  double friction = 0.25;               ///< mu
  double work_of_adhesion = 0;          ///< J/m^2, w at the reference size
  double rolling_friction = 0;          ///< m, mu_r at the reference size (model B only)
  double air_viscosity = 2e-5;          ///< Pa s, mu_a at the reference size
  double apparent_density = 0;          ///< kg/m^3 of the real powder, as weighed; 0: not known
  /// m, model grain size d wanted, exactly (d / R) times the wanted R: coarse graining scales the rest to it.
  /// Where grains are of several sizes, that of the grain of mean mass.
  double grain_diameter = 6 * 7.84e-5;
  /// Sizes of the model grains (m), ascending, with their shares by number; empty: one size.
  std::vector<engine::CutClass> sizes;
  std::string sizes_text;  ///< for people; empty for one size
};

/// m, the smallest and the largest grain size wanted.
double smallest_grain(const PowderSpec& powder);
double largest_grain(const PowderSpec& powder);
/// Makes all grains larger by `factor`.
void enlarge(PowderSpec& powder, double factor);
/// m, of each particle type, ascending.
std::vector<double> grain_diameters(const PowderSpec& powder);

/// Wanted over reference grain size: the factor s by which coarse graining enlarges the grains; 1 for none.
double coarse_graining_factor(const PowderSpec& powder);

}  // namespace diefill::process
