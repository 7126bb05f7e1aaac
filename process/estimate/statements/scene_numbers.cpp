#include "process/estimate/statements/scene_numbers.h"

#include <cmath>

#include "process/estimate/cohesion.h"
#include "process/powder/material.h"

namespace diefill::process::estimate {

namespace {

void add_contact_numbers(const Scene& scene, std::vector<SceneNumber>& numbers) {
  const PowderSpec& powder = scene.powder;
  const double effective = powder.sphere_radius / 2;
  const double factor = coarse_graining_factor(powder);
  const double bond = bond_number(scene);
  const double solid = mean_grain(scene).solid_volume / (factor * factor * factor);
  const double density = powder.grain_mass / solid;
  numbers.push_back({"Bond", "largest adhesion of two grains over a grain's weight, at the powder's own size",
                     "Bierwisch 2009, Eq. 2.5", bond});
  if (factor > 1 + 1e-9)
    numbers.push_back({"Bond of the coarse grains",
                       "the same at the scene's grain size; stresses are kept, so bulk cohesion is",
                       "Bierwisch 2009, Eq. 3.7", bond / factor});
  numbers.push_back({"Pi_1", "adhesion over stiffness, w / (R_eff E~)", "Bierwisch 2009, Eq. 3.4",
                     powder.work_of_adhesion / (effective * powder.reduced_modulus)});
  numbers.push_back({"Pi_2", "damping, gamma_n / (R_eff sqrt(rho E~))", "Bierwisch 2009, Eq. 3.4",
                     powder.damping_over_radius * powder.sphere_radius /
                         (effective * std::sqrt(density * powder.reduced_modulus))});
  numbers.push_back(
      {"Pi_3", "tangential over normal stiffness, kappa_t / (R_eff E~)", "Bierwisch 2009, Eq. 3.4",
       powder.tangential_over_radius * powder.sphere_radius / (effective * powder.reduced_modulus)});
}

}  // namespace

std::vector<SceneNumber> scene_numbers(const Scene& scene, const Estimate& estimate) {
  std::vector<SceneNumber> numbers;
  for (const OpeningEstimate& opening : estimate.openings)
    if (opening.froude > 0)
      numbers.push_back({"Froude, " + opening.name,
                         "shoe speed over sqrt(g D), D the effective opening, times D over its length "
                         "along the motion where that is more; beyond 5 nothing runs in (Eq. 5.17)",
                         "Bierwisch 2009, section 5.2.2", opening.froude});
  if (!scene.contact) add_contact_numbers(scene, numbers);
  if (estimate.powder.air_number)
    numbers.push_back({"Ar rho_s/rho_air", "how little air slows the flow of the real powder",
                       "Guo et al. 2009, AIChE J. 55, 49", *estimate.powder.air_number});
  return numbers;
}

}  // namespace diefill::process::estimate
