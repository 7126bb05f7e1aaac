#include "process/plan/symmetry_plane.h"

#include <algorithm>
#include <cmath>

#include "process/machine/actions/powder_change.h"

namespace diefill::process::plan {

namespace {

constexpr double kParallel = 1e-6;

bool has_plane(const geometry::Symmetry& symmetry, const SymmetryPlane& plane, double tolerance) {
  if (std::abs(symmetry.centre.dot(plane.normal) - plane.offset) > tolerance) return false;
  const auto parallel = [&](const Eigen::Vector3d& normal) {
    return std::abs(normal.dot(plane.normal)) > 1 - kParallel;
  };
  if (std::any_of(symmetry.planes.begin(), symmetry.planes.end(), parallel)) return true;
  // What looks the same at every angle about an axis has every plane through it.
  return std::any_of(symmetry.axes.begin(), symmetry.axes.end(), [&](const auto& axis) {
    return axis.order == 0 && std::abs(axis.direction.dot(plane.normal)) < kParallel;
  });
}

bool pours_symmetrically(const PourSpec& pour, const SymmetryPlane& plane, double tolerance) {
  // A box is its own mirror image across planes of its own axes only.
  if (plane.normal.cwiseAbs().maxCoeff() < 1 - kParallel) return false;
  const Eigen::Vector3d middle = 0.5 * (pour.lower + pour.upper);
  return std::abs(middle.dot(plane.normal) - plane.offset) <= tolerance;
}

/// Tools may move along the plane and turn about its normal.
bool moves_symmetrically(const Step& step, const SymmetryPlane& plane) {
  constexpr int kInstants = 64;
  constexpr double kOpenEnded = 1;  // s, long enough to see what such a step does
  const double length = step.open_ended() ? kOpenEnded : step.duration().value_or(kOpenEnded);
  for (int n = 0; n <= kInstants; ++n) {
    const ToolMotion motion = step.motion(length * n / kInstants);
    const double way = std::max(motion.translation.norm(), 1e-12);
    const double speed = std::max(motion.velocity.norm(), 1e-12);
    if (std::abs(motion.translation.dot(plane.normal)) > kParallel * way) return false;
    if (std::abs(motion.velocity.dot(plane.normal)) > kParallel * speed) return false;
    if ((motion.rotation * plane.normal - plane.normal).norm() > kParallel) return false;
    if (motion.angular_velocity.cross(plane.normal).norm() > kParallel * motion.angular_velocity.norm())
      return false;
  }
  return true;
}

/// Gravity across the plane, at the start or from a step on; empty: none.
std::string gravity_across(const Scene& scene, const SymmetryPlane& plane) {
  if (scene.gravity.dot(plane.normal) != 0) return "gravity";
  for (const auto& step : scene.steps) {
    const PowderChange* change = step->change();
    if (change != nullptr && change->gravity && change->gravity->dot(plane.normal) != 0)
      return "gravity from the step on: " + step->description();
  }
  return {};
}

std::string asymmetry_of(const Scene& scene, const SymmetryPlane& plane, double tolerance) {
  if (std::string gravity = gravity_across(scene, plane); !gravity.empty()) return gravity;
  if (!pours_symmetrically(scene.pour, plane, tolerance)) return "the pour box";
  // Periods are centred on the origin.
  const auto period = scene.numerics.period[plane.normal[0] > 0.5 ? 0 : 1];
  if (period && std::abs(plane.offset) > tolerance) return "the period";
  for (const auto& step : scene.steps) {
    if (step->inflow() != nullptr) return "the inflow of powder";
    if (!step->tools().empty() && !moves_symmetrically(*step, plane))
      return "the motion: " + step->description();
  }
  return {};
}

}  // namespace

std::vector<SymmetryPlane> common_planes(const Scene& scene, const Tooling& tooling,
                                         const std::vector<geometry::Symmetry>& symmetry, double tolerance) {
  std::vector<SymmetryPlane> common;
  const std::array<Eigen::Vector3d, 2> across = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()};
  for (const Eigen::Vector3d& normal : across) {
    SymmetryPlane plane{normal, 0, {}};
    // The die says where the plane would be.
    plane.offset = symmetry[tooling.die].centre.dot(normal);
    const bool all = std::all_of(symmetry.begin(), symmetry.end(),
                                 [&](const auto& found) { return has_plane(found, plane, tolerance); });
    if (!all) continue;
    plane.asymmetry = asymmetry_of(scene, plane, tolerance);
    common.push_back(std::move(plane));
  }
  return common;
}

}  // namespace diefill::process::plan
