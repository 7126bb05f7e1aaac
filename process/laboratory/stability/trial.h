// What the experiments on stability share: searching a limit by bisection, the powders they are made with and
// the energy that appears from nowhere.
#pragma once

#include <functional>

#include "engine/laws/bierwisch_law.h"
#include "engine/simulation/simulation.h"

namespace diefill::process::laboratory {

/// Largest value at which `holds` is true, to within a factor of 1 + `precision`, by bisecting the logarithm
/// between `lower` and `upper`; the end itself where the answer is the same all the way. The answer must
/// change once.
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

/// Energy (J) that came from nowhere in `steps` steps, over `scale` (J): twice what the ledger does not
/// explain in the mean over the last quarter of the run less that over the second, so that the steady offset
/// between the energy of velocity Verlet and the true one does not count as growth. Infinite where the powder
/// left all bounds or gained more than `scale`.
double spurious_energy(engine::Simulation& simulation, long steps, double scale);

}  // namespace diefill::process::laboratory
