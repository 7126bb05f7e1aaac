// Tools that would collide during the steps of a scene.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "geometry/reach/moving_pair.h"
#include "process/tooling/tooling.h"

namespace diefill::engine {
class Simulation;
}  // namespace diefill::engine

namespace diefill::process {

/// Two tools, one of which would cut into the other.
struct ToolCollision {
  std::string one, other;                           ///< names
  std::string where;                                ///< place of the step in the scene file; empty: no step's
  double since = 0;                                 ///< s after that step began
  double depth = 0;                                 ///< m, of the first cut
  double deepest = 0;                               ///< m, on the whole way
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< m, of the first cut
  std::string description() const;                  ///< without `where`
};

/// A tool that would cut into another; the places are for a picture.
struct ToolsCollide : SceneError {
  ToolsCollide(const std::string& message, std::vector<ToolCollision> found)
      : SceneError(message), collisions(std::move(found)) {}
  std::vector<ToolCollision> collisions;
};

/// Depth (m) up to which two tools may be in each other: the larger radius of their wall spheres, as at the
/// start, and at most a quarter of the thinner one's mean thickness.
double allowed_depth(const Scene& scene, const Tool& one, const Tool& other);

/// Paths of tools under force control, and of free ones, are not known in advance.
enum class ForcedTools { stand, full_travel };

/// Follows all tools through all steps, which must have been prepared, and checks every pair in relative
/// motion at poses at most half a millimetre apart; poses checked before are skipped. One collision per pair
/// at most.
std::vector<ToolCollision> find_collisions(const Scene& scene, const Tooling& tooling, ForcedTools forced);

/// Throws ToolsCollide for the collisions of prescribed motions.
void refuse_collisions(const Scene& scene, const Tooling& tooling);

/// Monitors, during a run, the tools under force control and those that are free.
class ForcedToolWatch {
 public:
  /// Keeps a reference to `tooling`.
  ForcedToolWatch(const Scene& scene, const Tooling& tooling);
  /// Throws engine::OutOfRange when such a tool cuts into another.
  void check(const engine::Simulation& simulation);

 private:
  struct Pair {
    std::size_t one, other;
    std::unique_ptr<geometry::MovingPair> solids;
  };
  const Tooling& tooling_;
  std::vector<Pair> pairs_;
};

}  // namespace diefill::process
