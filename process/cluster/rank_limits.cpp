#include "process/cluster/rank_limits.h"

#include "process/input/scene_error.h"
#include "process/machine/free_motion.h"

namespace diefill::process::cluster {

namespace {

/// Whether gravity has a part along a periodic axis: a grain that crosses the periodic boundary would gain
/// energy that the energy balance does not include.
bool falls_round(const Scene& scene, const Eigen::Vector3d& gravity) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (scene.numerics.period[axis] && gravity[static_cast<Eigen::Index>(axis)] != 0) return true;
  return false;
}

/// Whether a grain that crosses a periodic boundary comes to the other side of the probe's plane: ranks do
/// not tell which grains do.
bool goes_round(const Scene& scene, const ProbeSpec& probe) {
  if (probe.quantity != ProbeQuantity::flow) return false;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (scene.numerics.period[axis] && probe.normal[static_cast<Eigen::Index>(axis)] != 0) return true;
  return false;
}

[[noreturn]] void refuse(const Scene& scene, const std::string& what, const std::string& remedy) {
  throw SceneError(scene.file.string() + ": " + what + " is not supported on ranks (--ranks): " + remedy +
                   ", or run without --ranks");
}

}  // namespace

void refuse_unsupported_on_ranks(const Scene& scene) {
  if (scene.economy.sleep) refuse(scene, "economy.sleep", "remove the key");
  if (scene.economy.carry_beyond) refuse(scene, "economy.carry_beyond", "remove the key");
  for (const auto& step : scene.steps)
    if (free_motion_of(*step) != nullptr)
      refuse(scene, "a tool that moves freely (\"" + step->description() + "\")", "prescribe its motion");
  for (const ProbeSpec& probe : scene.probes)
    if (goes_round(scene, probe))
      refuse(scene, "the flow along a periodic axis (probe \"" + probe.name + "\")",
             "turn its normal or remove the probe");
  if (falls_round(scene, scene.gravity))
    refuse(scene, "gravity along a periodic axis", "change the direction of gravity or the periodic axis");
}

}  // namespace diefill::process::cluster
