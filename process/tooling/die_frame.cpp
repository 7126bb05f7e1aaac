#include "process/tooling/die_frame.h"

#include "engine/simulation/simulation.h"
#include "process/measure/cavity_position.h"
#include "process/tooling/grain_tally.h"
#include "process/tooling/half_model.h"

namespace diefill::process {

namespace {

constexpr double kPoseTolerance = 1e-12;  // m and rad, rounding of a motion that comes back

}  // namespace

results::CavityState cavity_state(const geometry::Cavity& found) {
  results::CavityState cavity;
  cavity.is_ring = found.is_ring;
  cavity.axis_origin = found.axis_origin;
  cavity.inner_radius = found.inner_radius;
  cavity.outer_radius = found.outer_radius;
  if (found.found) {
    cavity.lower_corner = found.box.lower;
    cavity.upper_corner = found.box.upper;
  }
  cavity.volume = found.volume;
  cavity.narrowest_width = found.narrowest_width;
  return cavity;
}

bool DieFrame::at_initial_pose() const {
  return die_.translation.norm() < kPoseTolerance &&
         (die_.rotation - Eigen::Matrix3d::Identity()).norm() < kPoseTolerance;
}

engine::BodyMotion DieFrame::pose(const engine::BodyMotion& body) const {
  engine::BodyMotion posed;
  posed.rotation = die_.rotation.transpose() * body.rotation;
  posed.translation = point(body.translation);
  return posed;
}

results::PowderState DieFrame::powder(results::PowderState laboratory) const {
  const Eigen::Quaterniond back(Eigen::Matrix3d(die_.rotation.transpose()));
  for (auto& position : laboratory.position) position = point(position);
  for (auto& velocity : laboratory.velocity) velocity = direction(velocity);
  for (auto& spin : laboratory.angular_velocity) spin = direction(spin);
  for (auto& orientation : laboratory.orientation) {
    const Eigen::Quaterniond turned =
        back * Eigen::Quaterniond(orientation[0], orientation[1], orientation[2], orientation[3]);
    orientation = {turned.w(), turned.x(), turned.y(), turned.z()};
  }
  return laboratory;
}

double filled_mass(const engine::Simulation& simulation, const Tooling& tooling) {
  const results::CavityState cavity = cavity_state(tooling.cavity);
  const DieFrame frame(simulation.body_motion(tooling.die));
  GrainTally filled;
  const engine::Grains& grains = simulation.grains();
  for (std::size_t k = 0; k < grains.size(); ++k)
    if (lies_in_cavity(cavity, frame.point(grains.position[k]))) filled.add(grains.type_of(k));
  return copies(tooling) * filled.mass(simulation.types());
}

}  // namespace diefill::process
