// The one loop over touching pairs, for grains and for walls, templated on the contact law so that terms a
// scene does not use are not in it. A scene picks its instantiation once.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/contact/deepest_overlap.h"
#include "engine/contact/local_spheres.h"
#include "engine/laws/contact_parameters.h"
#include "engine/numerics/vector_instructions.h"
#include "engine/powder/particle_types.h"

namespace diefill::engine {

// Not included here: the loop of grains, which compiles for minutes, need not know walls.
struct ContactWorkspace;
class WallBody;
struct BodyMotion;

/// What one block did in one step.
struct BlockTally {
  double viscous_work = 0;     ///< J, done by damping (negative)
  double tangential_work = 0;  ///< J, done by tangential forces
  double drag_work = 0;        ///< J, done by air (negative)
  double rolling_work = 0;     ///< J, done by rolling friction (negative)
  DeepestOverlap overlap;      ///< m
  bool list_is_old = false;    ///< a grain has moved farther than the neighbour list allows
  std::uint64_t touching = 0;  ///< pairs
  /// s, of computing the block's pairs and of finishing what was ready then; where the two take turns.
  double computing_time = 0, finishing_time = 0;
  std::vector<Eigen::Vector3d> body_force;   ///< N on each wall body
  std::vector<Eigen::Vector3d> body_torque;  ///< N m about the origin of each body's frame

  void start(std::size_t bodies);
};

/// A block's surroundings that contacts are computed from.
struct ContactScene {
  const LocalSpheres& spheres;
  const std::vector<WallBody>& bodies;
  const std::vector<BodyMotion>& body_motion;
  double sphere_radius;  ///< m, the smallest
  double time_step;      ///< s
  InstructionSet instructions;
};

/// The force of one touching pair: on the block's sphere `own` from its partner, or from the wall.
struct PairForce {
  LocalSphere own, other;  ///< `other` means nothing at walls
  Vector3 force;           ///< N, on own
  Vector3 contact;         ///< m, middle of the overlap, where `own` is seen
};
using PairForceVisitor = std::function<void(const PairForce&)>;

/// Contact forces of a block's pairs.
class PairLoop {
 public:
  virtual ~PairLoop() = default;
  /// Adds the forces of the block's touching pairs to the sums of `workspace`, which is the calling thread's
  /// own, and advances their histories.
  virtual void add_forces(Block& block, const ContactScene& scene, ContactWorkspace& workspace,
                          BlockTally& tally) const = 0;
  /// Visits the forces of the pairs that touched in the last step, in the order of the table, as they stand:
  /// nothing is advanced.
  virtual void visit_forces(const Block& block, const ContactScene& scene,
                            const PairForceVisitor& visit) const = 0;
  /// Energy (J) that the normal springs of the block's pairs hold.
  virtual double stored_energy(const Block& block, const ContactScene& scene) const = 0;
  /// For each number of a history: what it is multiplied by when the pair is stored the other way round.
  virtual std::vector<double> history_signs() const = 0;
  /// Of each of the loop's laws, in an order that types and walls give.
  virtual std::vector<HistoryLayout> history_layouts() const = 0;
  /// Sets to 0 the numbers of the block's histories that mean something else by the layouts `next`, which are
  /// those of a loop for the same types and walls with histories of the same length.
  virtual void clear_changed_history(Block& block, const std::vector<HistoryLayout>& next) const = 0;
  /// Whether rolling loads of sums count.
  virtual bool rolls() const = 0;
  /// m, largest gap at which pairs act on each other.
  virtual double range() const = 0;
};

struct WallSurface;

/// The loop for pairs between grains: a tuned one where all grains are of one type and their law is
/// Bierwisch's, with just the terms that are not 0; otherwise one for laws of any parts. Throws
/// std::invalid_argument where materials have no law or its parts do not go together.
std::unique_ptr<PairLoop> make_grain_loop(const ParticleTypes& types, const ContactLaws& contact,
                                          LeverArm arm);
/// The same for pairs of grains with walls, one surface for each body. Throws where a wall is to attract from
/// afar as well.
std::unique_ptr<PairLoop> make_wall_loop(const ParticleTypes& types, const ContactLaws& contact, LeverArm arm,
                                         const std::vector<WallSurface>& surfaces);

}  // namespace diefill::engine
