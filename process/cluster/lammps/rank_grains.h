// The grains of one rank: its own, and copies of those of other ranks that its own may touch (LAMMPS' ghost
// atoms). One atom of LAMMPS is one grain; its spheres are placed when they are needed.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/powder/rigid_motion.h"
#include "engine/powder/sphere_field.h"
#include "engine/simulation/computed_step.h"
#include "process/cluster/lammps/powder_model.h"

namespace diefill::process::cluster {

/// State of a rank's grains. Own grains come first, in the order of LAMMPS' atoms.
struct RankGrains {
  explicit RankGrains(const PowderModel& powder_model);

  const PowderModel& model;
  std::size_t own = 0, all = 0;
  engine::Grains grains;  ///< own ones; velocities and spins of single spheres are predicted during steps
  engine::SphereField motion;  ///< of own clumps: predicted velocities and spins, laboratory frame
  /// Of all grains, three numbers each, LAMMPS' arrays: m, m/s and rad/s, predicted for the end of the step.
  const double *place = nullptr, *velocity = nullptr, *spin = nullptr;
  const int *type = nullptr, *tag = nullptr;         ///< of all; both count from 1
  std::vector<engine::PlainQuaternion> orientation;  ///< of all, where grains are clumps
  std::vector<engine::Vector3> sphere;               ///< m, centres of the spheres of all
  std::vector<engine::ContactSum> sums;              ///< contacts' forces on own grains
  std::vector<engine::BodyMotion> body_motion;       ///< at the present time
  /// Contact history of own grains from one search to the next, one record after the other (memory_record.h).
  /// Sent with the grain.
  std::vector<std::vector<double>> memory;

  engine::Vector3 centre(std::size_t grain) const { return vector_at(place, grain); }
  engine::Vector3 velocity_of(std::size_t grain) const { return vector_at(velocity, grain); }
  engine::Vector3 spin_of(std::size_t grain) const { return vector_at(spin, grain); }
  engine::TypeNumber type_of(std::size_t grain) const {
    return static_cast<engine::TypeNumber>(type[grain] - 1);
  }
  /// Class of sphere `number` of a grain.
  engine::ClassNumber class_of(std::size_t grain, std::size_t number) const {
    return model.types.class_of(type_of(grain), number);
  }
  std::size_t spheres_of(std::size_t grain) const { return model.types.shape(type_of(grain)).spheres(); }

  /// Places the spheres of all grains.
  void place_spheres();

 private:
  static engine::Vector3 vector_at(const double* numbers, std::size_t k) {
    return {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
  }
};

/// What contacts did in a step, on one rank. A pair that two ranks compute counts half on each.
struct ContactFigures {
  double viscous_power = 0, friction_power = 0, rolling_power = 0;  ///< W
  double touching = 0;                                              ///< pairs
  engine::DeepestOverlap overlap;                                   ///< m
  std::vector<engine::WallLoad> loads;                              ///< on the bodies

  void start(std::size_t bodies) {
    *this = {};
    loads.assign(bodies, {});
  }
};

/// The list of near grains that LAMMPS keeps: half of the pairs, and those with ghosts on both ranks.
struct NearGrains {
  int count = 0;  ///< grains that have partners
  const int *grain = nullptr, *partners = nullptr;
  const int* const* first = nullptr;
};

/// Contacts of one kind on a rank: among grains, or with walls.
class ContactPass {
 public:
  virtual ~ContactPass() = default;
  /// Finds near pairs; those that touched get their history back from the grains' memory.
  virtual void search(const RankGrains& grains, const NearGrains& near) = 0;
  /// Adds the forces of a step to the sums of `grains`.
  virtual void add_forces(RankGrains& grains, ContactFigures& figures) = 0;
  /// Appends the history of touching pairs to the memory of own grains.
  virtual void store_history(RankGrains& grains) const = 0;
  /// Appends the touching pairs that this rank answers for, so that each is named once over all ranks.
  virtual void name_contacts(const RankGrains& grains, engine::NamedContacts& named) const = 0;
  /// Length of a touching pair's history, and the factors that turn it into the history seen from the other
  /// side.
  virtual std::vector<double> history_signs() const = 0;
  /// Whether rolling loads of sums count.
  virtual bool rolls() const = 0;
};

/// The passes for a model: the law of each pair is the one that the built-in engine would take. Throws
/// std::invalid_argument where materials have no law.
std::unique_ptr<ContactPass> make_grain_pass(const PowderModel& model);
std::unique_ptr<ContactPass> make_wall_pass(const PowderModel& model);

}  // namespace diefill::process::cluster
