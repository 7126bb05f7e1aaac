#include "engine/observe/contact_stress.h"

#include "engine/observe/contact_forces.h"
#include "engine/simulation/simulation.h"

namespace diefill::engine {

std::vector<Eigen::Matrix3d> contact_stress_times_volume(const Simulation& simulation) {
  std::vector<Eigen::Matrix3d> stress(simulation.grains().size(), Eigen::Matrix3d::Zero());
  visit_contact_forces(simulation, [&](const ContactForce& contact) {
    stress[contact.grain] += contact.force * contact.arm.transpose();
    if (contact.other != kNoGrain) stress[contact.other] -= contact.force * contact.other_arm.transpose();
  });
  return stress;
}

}  // namespace diefill::engine
