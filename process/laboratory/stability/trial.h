// Shared by the experiments on stability: the search for a limit by bisection, their powders and contacts,
// and the energy that no work explains.
#pragma once

#include <functional>
#include <vector>

#include "engine/laws/bierwisch_law.h"
#include "engine/powder/particle_types.h"
#include "engine/walls/walls.h"

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process::laboratory {

/// Largest value between `lower` and `upper` at which `holds` is true, to within a factor of 1 + `precision`,
/// by bisection of its logarithm. `holds` may change once, from true to false; where it does not, the result
/// is `upper` (true throughout) or `lower` (false throughout).
double largest_that_holds(double lower, double upper, double precision,
                          const std::function<bool(double)>& holds);

/// `count` values from `lower` to `upper`, evenly spaced as logarithms.
std::vector<double> logarithmic_range(double lower, double upper, int count);
std::vector<double> linear_range(double lower, double upper, int count);

enum class ThesisGrain { sphere, c, d };

/// Bierwisch's grains of 7.63e-8 kg (2009, Table C.4); the sphere is model A.
engine::GrainShape thesis_grain(ThesisGrain kind);

/// E~ = 1e7 Pa, no damping, no friction (2009, Table C.4).
engine::ContactParameters elastic_contact();

/// Grains and walls under Bierwisch's law.
engine::ContactLaws bierwisch_contact(const engine::ContactParameters& grains,
                                      const engine::ContactParameters& walls);

/// Flat walls without end at z = `lower` and `upper` (m), powder between them.
engine::WallBodySpec plates(double lower, double upper);
engine::WallBodySpec floor_plate();

/// s, Rayleigh time of a sphere of `radius` (m) and `density` (kg/m^3): pi R / (0.8766 + 0.163 nu)
/// sqrt(2 rho (1 + nu) / E) with E = E~ (1 - nu^2), nu = 0.3 (Hu 2024, Eq. 2.52).
double rayleigh_time(double radius, double density, double reduced_modulus);

/// s, of a head-on collision of two grains at relative speed `speed` (m/s), undamped Hertz: 3.218 (m_eff^2 /
/// (k^2 v))^(1/5).
double collision_time(const engine::GrainShape& shape, const engine::ContactParameters& contact,
                      double speed);

/// Growth of the energy that no work explains (J) in `steps` steps, over `scale` (J): twice the difference
/// between its means over the last and over the second quarter of the run, so that the constant offset of
/// velocity Verlet's energy from the true one does not count. Infinite where the powder left all bounds or
/// gained more than `scale`.
double spurious_energy(engine::Simulation& simulation, long steps, double scale);

}  // namespace diefill::process::laboratory
