#include "process/estimate/exposure.h"

#include <algorithm>
#include <cmath>

#include "process/tooling/plan_view.h"
#include "process/tooling/stages.h"

namespace diefill::process::estimate {

namespace {

constexpr int kDense = 400;          // instants of a step
constexpr double kJustAbove = 5e-4;  // m above the shoe's lower edge, where its opening is taken
constexpr double kAtRest = 1e-3;     // m of travel below which the shoe stands

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

 private:
  Opening opening_;
  Eigen::Vector2d lower_, upper_;
};

/// The shoe seen from the die at one time.
struct ShoePose {
  double time;
  Eigen::Matrix2d turn;   // takes places of the die to the shoe's frame
  Eigen::Vector2d shift;  // m
  Eigen::Vector2d place_in_shoe(const Eigen::Vector2d& at) const { return turn * (at - shift); }
};

std::vector<ShoePose> poses_of(const Scene& scene, const Tooling& tooling, const std::string& shoe) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  const std::string& die = tooling.tools[tooling.die].spec.name;
  std::vector<ShoePose> poses;
  for (const double time : instants(stages, states, kDense)) {
    const ToolPose below = pose_of(stages, states, die, time), above = pose_of(stages, states, shoe, time);
    const Eigen::Matrix3d turn = above.rotation.transpose() * below.rotation;
    const Eigen::Vector3d shift = below.rotation.transpose() * (above.translation - below.translation);
    poses.push_back({time, turn.topLeftCorner<2, 2>(), shift.head<2>()});
  }
  return poses;
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
    if (over && !was_over) {
      // It came between two instants: half way, on average.
      found.push_back({k > 0 ? 0.5 * (poses[k - 1].time + poses[k].time) : poses[k].time, 0, 0});
      entered = k > 0 ? Eigen::Vector2d(0.5 * (poses[k - 1].shift + poses[k].shift)) : poses[k].shift;
    }
    if (was_over || over) {
      const bool leaves = was_over && !over;
      const double time = leaves ? 0.5 * (poses[k - 1].time + poses[k].time) : poses[k].time;
      const Eigen::Vector2d shift =
          leaves ? Eigen::Vector2d(0.5 * (poses[k - 1].shift + poses[k].shift)) : poses[k].shift;
      found.back().seconds = std::max(0.0, time - found.back().began);
      found.back().travel = (shift - entered).norm();
    }
    was_over = over;
  }
  return found;
}

/// Sets speed and length, the means over the area of the openings, of the first crossing that moves.
void measure_path(const OpeningLayout& layout, ShoePath& path) {
  double area = 0, length = 0, seconds = 0;
  for (std::size_t k = 0; k < layout.places.size(); ++k) {
    path.crossings = std::max(path.crossings, path.exposures[k].size());
    for (const Exposure& exposure : path.exposures[k]) {
      if (exposure.travel < kAtRest) continue;
      area += layout.places[k].area;
      length += layout.places[k].area * exposure.travel;
      seconds += layout.places[k].area * exposure.seconds;
      break;
    }
  }
  if (!(area > 0)) return;
  path.length = length / area;
  path.speed = length / seconds;
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
  const auto poses = poses_of(scene, tooling, path.tool);
  if (poses.empty()) return path;
  const Footprint powder(scene, *shoe);
  path.direction = direction_of(poses);
  for (std::size_t k = 0; k < layout.places.size(); ++k) {
    layout.places[k].chord = layout.outline.chord(layout.places[k].at, path.direction);
    path.exposures[k] = exposures_of(layout.places[k], powder, poses);
  }
  measure_path(layout, path);
  return path;
}

}  // namespace diefill::process::estimate
