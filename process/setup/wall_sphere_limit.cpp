#include "process/setup/wall_sphere_limit.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "process/results/formatted.h"
#include "process/tooling/examination/tool_fit.h"
#include "process/tooling/machine_memory.h"
#include "process/tooling/predicted_memory.h"

namespace diefill::process {

namespace {

/// m^2 of the mesh, and points spread over it by area, each with the outward normal there.
class SpreadPoints {
 public:
  explicit SpreadPoints(const geometry::Mesh& mesh) : mesh_(mesh) {
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
      area_ += 0.5 * twice_area(k).norm();
      up_to_.push_back(area_);
    }
  }
  double area() const { return area_; }

  /// Calls visit(point, normal) for `count` points.
  template <class Visit>
  void each(int count, const Visit& visit) const {
    constexpr double kGolden = 0.6180339887498949, kPlastic = 0.7548776662466927;
    for (int n = 0; n < count; ++n) {
      const double at = area_ * (n + 0.5) / count;
      const auto k =
          static_cast<std::size_t>(std::lower_bound(up_to_.begin(), up_to_.end(), at) - up_to_.begin());
      if (k >= up_to_.size()) continue;
      double u = std::fmod(n * kGolden, 1.0), v = std::fmod(n * kPlastic, 1.0);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Eigen::Vector3d a = corner(k, 0);
      visit(Eigen::Vector3d(a + u * (corner(k, 1) - a) + v * (corner(k, 2) - a)),
            Eigen::Vector3d(twice_area(k).normalized()));
    }
  }

 private:
  const Eigen::Vector3d& corner(std::size_t k, int which) const {
    return mesh_.vertices[static_cast<std::size_t>(mesh_.triangles[k][which])];
  }
  Eigen::Vector3d twice_area(std::size_t k) const {
    return (corner(k, 1) - corner(k, 0)).cross(corner(k, 2) - corner(k, 0));
  }

  const geometry::Mesh& mesh_;
  std::vector<double> up_to_;
  double area_ = 0;
};

bool beyond_period(const Scene& scene, const Eigen::Vector3d& point) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const auto& period = scene.numerics.period[axis];
        period && std::abs(point[static_cast<Eigen::Index>(axis)]) > 0.5 * *period)
      return true;
  return false;
}

}  // namespace

void refuse_too_many_wall_spheres(
    const Scene& scene, const Tooling& tooling,
    const std::function<bool(std::size_t, const Eigen::Vector3d&, const Eigen::Vector3d&)>& reachable) {
  constexpr int kPoints = 4000;
  const double room = machine_memory() - plan::predicted_memory(0, 0),
               each = plan::predicted_memory(0, 1) - plan::predicted_memory(0, 0);
  const double most = std::clamp(room / each, 1e5, kMaxWallSpheres);
  double all = 0;
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) {
    const Tool& tool = tooling.tools[k];
    const double radius = tool.spec.sphere_radius.value_or(scene.walls.sphere_radius),
                 spacing = tool.spec.spacing.value_or(scene.walls.spacing);
    const SpreadPoints points(tool.mesh);
    double spheres = points.area() / std::pow(spacing * radius, 2);
    if (spheres + all <= 0.1 * most) {
      all += spheres;
      continue;
    }
    int met = 0;
    points.each(kPoints, [&](const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
      if (!beyond_period(scene, point) && reachable(k, point, normal)) ++met;
    });
    spheres *= static_cast<double>(met) / kPoints;
    all += spheres;
    if (all <= most) continue;
    constexpr double kRoundedUp = 1.1;
    throw SceneError(tool_text(scene, tool.spec) +
                     results::formatted(
                         ": covering the reachable surface needs about %.3g wall spheres of radius %.4g mm, "
                         "allowed here: at most %.3g; use a radius of %.2g mm or more (walls.sphere_radius "
                         "or the tool's), or a wider spacing",
                         all, 1e3 * radius, most, kRoundedUp * 1e3 * radius * std::sqrt(all / most)));
  }
}

}  // namespace diefill::process
