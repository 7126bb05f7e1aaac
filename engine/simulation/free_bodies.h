// Wall bodies of a simulation that move by the forces on them (walls/free_body.h). A simulation takes any
// motion of its bodies as given; here it follows from the loads that the simulation has found.
#pragma once

#include <memory>
#include <vector>

#include "engine/walls/free_body.h"

namespace diefill::engine {

class Simulation;

/// The free bodies of one simulation. Loads are summed in a fixed order, so that the motion has the same bits
/// on any number of threads.
class FreeBodies {
 public:
  /// Lets a body move by forces from now on. Throws std::invalid_argument as released() does, for a body that
  /// is free already, and where grains sleep: their loads are not computed.
  void release(const FreeBodySpec& spec, Simulation& simulation);
  /// Holds a free body where it is, at rest.
  void hold(std::size_t body, Simulation& simulation);

  /// To be called before and after every step of the simulation.
  void before_step(const Simulation& simulation);
  void after_step(Simulation& simulation);
  /// To be called when something else has set motions of the simulation's bodies.
  void apply_motions(Simulation& simulation);

  bool any() const { return !bodies_.empty(); }
  /// In the order of their release; all that a restart needs.
  const std::vector<FreeBody>& state() const { return bodies_; }
  /// Goes on with `state`. To be called before the simulation itself is restored.
  void restore(const std::vector<FreeBody>& state, Simulation& simulation);
  /// Null for a body that has not been released. Valid until the next release.
  const FreeBody* of(std::size_t body) const;

 private:
  std::vector<FreeBody> bodies_;
  std::vector<std::shared_ptr<BodyMotion>> poses_;  ///< of each, as the simulation's motions read them
};

}  // namespace diefill::engine
