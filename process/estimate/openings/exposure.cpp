#include "process/estimate/openings/exposure.h"

#include <algorithm>
#include <cmath>

#include "process/estimate/openings/shoe_poses.h"
#include "process/tooling/examination/plan_view.h"

namespace diefill::process::estimate {

namespace {

constexpr double kJustAbove = 5e-4;  // m above the shoe's lower edge, where its opening is taken
constexpr double kAtRest = 1e-3;     // m of travel below which the shoe stands
constexpr double kStill = 1e-9;      // m between two instants, below which it does not move

/// Where powder stands in the shoe, in the shoe's frame.
class Footprint {
 public:
  Footprint(const Scene& scene, const Tool& shoe)
      : opening_(shoe.mesh, shoe.mesh.bounding_box().lower.z() +
                                std::min(kJustAbove, 0.1 * shoe.mesh.bounding_box().size().z())),
        lower_(scene.pour.lower.head<2>()),
        upper_(scene.pour.upper.head<2>()) {
    for (Eigen::Index axis = 0; axis < 2; ++axis)
      if (scene.numerics.period[static_cast<std::size_t>(axis)]) {
        lower_[axis] = -1e9;
        upper_[axis] = 1e9;
      }
  }
  bool holds(const Eigen::Vector2d& place) const {
    if (!opening_.empty()) return opening_.contains(place);
    return (place.array() >= lower_.array()).all() && (place.array() <= upper_.array()).all();
  }
  /// m, along a unit vector.
  double extent(const Eigen::Vector2d& direction) const {
    const Eigen::Vector2d size = opening_.empty() ? Eigen::Vector2d(upper_ - lower_) : opening_.size();
    return direction.cwiseAbs().dot(size);
  }

 private:
  Opening opening_;
  Eigen::Vector2d lower_, upper_;
};

/// The stretch of time between two poses, or the half of it in which the shoe comes or goes.
void add_stretch(const ShoePose& from, const ShoePose& to, double share, Exposure& exposure) {
  const double way = (to.shift - from.shift).norm();
  exposure.travel += share * way;
  if (way > kStill) exposure.moving += share * (to.time - from.time);
}

/// The stretches of time in which powder stands over `place`.
std::vector<Exposure> exposures_of(const OpeningPatch& place, const Footprint& powder,
                                   const std::vector<ShoePose>& poses) {
  std::vector<Exposure> found;
  bool was_over = false;
  Eigen::Vector2d entered = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const bool open = !place.opens || poses[k].time >= *place.opens;
    const bool over = open && powder.holds(poses[k].place_in_shoe(place.at));
    const ShoePose& before = poses[k > 0 ? k - 1 : k];
    // It comes and goes between two instants: half way, on average.
    const double between = 0.5 * (before.time + poses[k].time);
    if (over && !was_over) {
      found.push_back({between, 0, 0, 0, 0});
      entered = 0.5 * (before.shift + poses[k].shift);
    }
    if (was_over || over) {
      Exposure& exposure = found.back();
      const bool leaves = was_over && !over;
      const Eigen::Vector2d shift =
          leaves ? Eigen::Vector2d(0.5 * (before.shift + poses[k].shift)) : poses[k].shift;
      add_stretch(before, poses[k], was_over && over ? 1 : 0.5, exposure);
      exposure.seconds = std::max(0.0, (leaves ? between : poses[k].time) - exposure.began);
      exposure.reach = std::max(exposure.reach, (shift - entered).norm());
    }
    was_over = over;
  }
  return found;
}

/// Sets speed, stand and length, the means over the area of the openings, of the first crossing that moves.
void measure_path(const OpeningLayout& layout, ShoePath& path) {
  double area = 0, length = 0, travel = 0, moving = 0, standing = 0;
  for (std::size_t k = 0; k < layout.places.size(); ++k) {
    path.crossings = std::max(path.crossings, path.exposures[k].size());
    for (const Exposure& exposure : path.exposures[k]) {
      if (exposure.travel < kAtRest) continue;
      const double weight = layout.places[k].area;
      area += weight;
      length += weight * exposure.reach;
      travel += weight * exposure.travel;
      moving += weight * exposure.moving;
      standing += weight * exposure.standing();
      break;
    }
  }
  if (!(area > 0)) return;
  path.length = length / area;
  path.standing = standing / area;
  path.speed = travel / moving;
}

Eigen::Vector2d direction_of(const std::vector<ShoePose>& poses) {
  Eigen::Vector2d farthest = Eigen::Vector2d::Zero();
  for (const ShoePose& pose : poses)
    if ((pose.shift - poses.front().shift).norm() > farthest.norm())
      farthest = pose.shift - poses.front().shift;
  return farthest.norm() > kAtRest ? Eigen::Vector2d(farthest.normalized())
                                   : Eigen::Vector2d(Eigen::Vector2d::UnitX());
}

}  // namespace

ShoePath shoe_path(const Scene& scene, const Tooling& tooling, OpeningLayout& layout) {
  ShoePath path;
  path.exposures.resize(layout.places.size());
  const auto shoe = std::find_if(tooling.tools.begin(), tooling.tools.end(),
                                 [](const Tool& tool) { return tool.spec.role == ToolRole::shoe; });
  if (shoe == tooling.tools.end()) return path;
  path.tool = shoe->spec.name;
  const auto poses = shoe_poses(scene, tooling, path.tool);
  if (poses.empty()) return path;
  const Footprint powder(scene, *shoe);
  path.direction = direction_of(poses);
  path.extent = powder.extent(poses.front().turn * path.direction);
  path.pours = pours_until_at_rest(scene);
  for (std::size_t k = 0; k < layout.places.size(); ++k) {
    layout.places[k].chord = layout.outline.chord(layout.places[k].at, path.direction);
    path.exposures[k] = exposures_of(layout.places[k], powder, poses);
  }
  measure_path(layout, path);
  return path;
}

}  // namespace diefill::process::estimate
