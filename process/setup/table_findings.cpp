// Whether the table lies below the shoe's opening wherever its steps carry it.
#include <algorithm>
#include <cmath>

#include "process/results/formatted.h"
#include "process/setup/setup_findings.h"
#include "process/tooling/examination/plan_view.h"
#include "process/tooling/stages.h"

namespace diefill::process {

namespace {

constexpr int kDense = 60;           // instants of a step
constexpr int kCells = 120;          // each way, of all that the shoe sweeps
constexpr int kPlaces = 24;          // each way, of the shoe's opening
constexpr double kJustAbove = 5e-4;  // m above the shoe's lower edge, where its opening is taken
constexpr double kJustBelow = 2e-4;  // m below the fill plane, where the table is taken
constexpr double kLifted = 2e-3;     // m above the fill plane, from which on the shoe slides no more
constexpr double kUpright = 0.999;   // cosine of the shoe's tilt
constexpr double kFewBeyond = 0.02;  // share of the opening

/// The shoe seen from the die.
struct TimedPose {
  double time = 0;  ///< s
  ToolPose pose;
};

/// s, when the first step begins that clears powder away: what the shoe does afterwards is no matter.
double end_of_powder(const Stages& stages, const std::vector<StepState>& states) {
  double end = 1e9;
  for (std::size_t k = 0; k < stages.size(); ++k)
    if (stages.steps[k]->removal() != nullptr) end = std::min(end, states[k].started);
  return end;
}

/// Where the shoe slides on the table with powder in it.
std::vector<TimedPose> sliding_poses(const Scene& scene, const Tooling& tooling, const Tool& shoe) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  const std::string& die = tooling.tools[tooling.die].spec.name;
  const double end = end_of_powder(stages, states), bottom = shoe.mesh.bounding_box().lower.z();
  std::vector<double> times = instants(stages, states, kDense);
  times.insert(times.begin(), 0.0);
  std::vector<TimedPose> poses;
  for (const double time : times) {
    const ToolPose below = pose_of(stages, states, die, time),
                   above = pose_of(stages, states, shoe.spec.name, time);
    TimedPose seen{time, {}};
    seen.pose.rotation = below.rotation.transpose() * above.rotation;
    seen.pose.translation = below.rotation.transpose() * (above.translation - below.translation);
    const double height = bottom + seen.pose.translation.z() - tooling.fill_plane;
    if (time <= end && seen.pose.rotation(2, 2) > kUpright && height < kLifted) poses.push_back(seen);
  }
  return poses;
}

/// Places of the shoe's opening, m, in its frame.
std::vector<Eigen::Vector2d> places_in(const Opening& opening) {
  std::vector<Eigen::Vector2d> places;
  for (int j = 0; j < kPlaces; ++j)
    for (int i = 0; i < kPlaces; ++i) {
      const Eigen::Vector2d share((i + 0.5) / kPlaces, (j + 0.5) / kPlaces);
      const Eigen::Vector2d place = opening.lower() + opening.size().cwiseProduct(share);
      if (opening.contains(place)) places.push_back(place);
    }
  return places;
}

Eigen::Vector2d moved(const ToolPose& pose, const Eigen::Vector2d& place) {
  return (pose.rotation * Eigen::Vector3d(place.x(), place.y(), 0) + pose.translation).head<2>();
}

/// The table seen from above: all tools but shoes, with the holes and cavities in them.
class Table {
 public:
  Table(const Tooling& tooling, const geometry::Box& swept) : origin_(swept.lower.head<2>()) {
    cell_ = (swept.size().head<2>() / kCells).cwiseMax(1e-9);
    for (const Tool& tool : tooling.tools)
      if (tool.spec.role != ToolRole::shoe) views_.emplace_back(tool.mesh, tooling.fill_plane - kJustBelow);
    below_.resize(static_cast<std::size_t>(kCells) * kCells);
    for (int j = 0; j < kCells; ++j)
      for (int i = 0; i < kCells; ++i)
        below_[static_cast<std::size_t>(j) * kCells + static_cast<std::size_t>(i)] =
            lies_below(origin_ + cell_.cwiseProduct(Eigen::Vector2d(i + 0.4871, j + 0.5137)));
  }
  bool contains(const Eigen::Vector2d& place) const {
    const Eigen::Array2d at = (place - origin_).array() / cell_.array();
    const auto cell = [](double along) {
      return static_cast<std::size_t>(std::clamp(along, 0.0, kCells - 0.5));
    };
    return below_[cell(at.y()) * kCells + cell(at.x())];
  }
  /// m, to the nearest edge.
  double distance(const Eigen::Vector2d& place) const {
    double least = 1e300;
    for (const PlanView& view : views_) least = std::min(least, view.distance(place));
    return least;
  }
  /// m, how exactly it knows where it ends.
  double exactness() const { return cell_.norm(); }

 private:
  /// On steel, or in a hole that walls surround.
  bool lies_below(const Eigen::Vector2d& place) const {
    std::array<bool, 4> walls = {};
    for (const PlanView& view : views_) {
      if (view.solid(place)) return true;
      const auto beside = view.walls_beside(place);
      for (std::size_t side = 0; side < 4; ++side) walls[side] = walls[side] || beside[side];
    }
    return std::all_of(walls.begin(), walls.end(), [](bool wall) { return wall; });
  }

  Eigen::Vector2d origin_, cell_;
  std::vector<PlanView> views_;
  std::vector<bool> below_;
};

/// How far the opening reaches beyond the table at one time.
struct Beyond {
  double time = 0, share = 0, distance = 0;  ///< s; of the opening; m
  Eigen::Vector2d farthest = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector3d> places;
};

geometry::Box swept_by(const std::vector<TimedPose>& poses, const std::vector<Eigen::Vector2d>& places) {
  geometry::Box box;
  for (const TimedPose& seen : poses)
    for (const auto& place : places) {
      const Eigen::Vector2d at = moved(seen.pose, place);
      box.include(Eigen::Vector3d(at.x(), at.y(), 0));
    }
  return box;
}

/// Sets which of the places beyond the table is farthest from it.
void find_farthest(const Table& table, Beyond& beyond) {
  for (const auto& place : beyond.places)
    if (const double far = table.distance(place.head<2>()); far > beyond.distance) {
      beyond.distance = far;
      beyond.farthest = place.head<2>();
    }
}

/// Where most of the opening is beyond the table, and of these times when it is farthest.
Beyond farthest_beyond(const Table& table, const std::vector<TimedPose>& poses,
                       const std::vector<Eigen::Vector2d>& places, double z) {
  Beyond most;
  for (const TimedPose& seen : poses) {
    Beyond beyond{seen.time, 0, 0, Eigen::Vector2d::Zero(), {}};
    for (const auto& place : places)
      if (const Eigen::Vector2d at = moved(seen.pose, place); !table.contains(at))
        beyond.places.emplace_back(at.x(), at.y(), z);
    beyond.share = static_cast<double>(beyond.places.size()) / static_cast<double>(places.size());
    if (beyond.places.empty() || beyond.share < most.share) continue;
    find_farthest(table, beyond);
    if (beyond.share > most.share || beyond.distance > most.distance) most = beyond;
  }
  return most;
}

SetupFinding over_the_edge(const Tool& shoe, const Beyond& beyond) {
  const std::string when =
      beyond.time > 0
          ? results::formatted("goes beyond the edge of the table, by most at t = %.3g s", beyond.time)
          : std::string("starts beyond the edge of the table");
  return {
      "the opening of shoe \"" + shoe.spec.name + "\" " + when +
          results::formatted(": %.0f %% of it, %.2g mm past the edge near x = %.4g mm, y = %.4g mm, where "
                             "powder falls off; shorten its travel, place it nearer to the cavity, or use a "
                             "larger table",
                             100 * beyond.share, 1e3 * beyond.distance, 1e3 * beyond.farthest.x(),
                             1e3 * beyond.farthest.y()),
      beyond.places};
}

/// Whether a plate that belongs to the table goes elsewhere.
bool table_changes(const Scene& scene) {
  const Stages stages(scene);
  return std::any_of(scene.tools.begin(), scene.tools.end(), [&](const ToolSpec& tool) {
    return tool.role == ToolRole::plate && stages.moves(tool.name);
  });
}

}  // namespace

std::vector<SetupFinding> table_findings(const Scene& scene, const Tooling& tooling) {
  std::vector<SetupFinding> findings;
  if (scene.numerics.period[0] || scene.numerics.period[1] || table_changes(scene)) return findings;
  for (const Tool& tool : tooling.tools) {
    if (tool.spec.role != ToolRole::shoe) continue;
    const geometry::Box box = tool.mesh.bounding_box();
    const Opening opening(tool.mesh, box.lower.z() + std::min(kJustAbove, 0.1 * box.size().z()));
    if (opening.empty()) continue;  // open on a side: what it holds is not known
    const auto poses = sliding_poses(scene, tooling, tool);
    const auto places = places_in(opening);
    if (poses.empty() || places.empty()) continue;
    const Table table(tooling, swept_by(poses, places));
    const Beyond beyond = farthest_beyond(table, poses, places, tooling.fill_plane);
    const double least = std::max(table.exactness(), 0.5 * scene.powder.grain_diameter);
    if (beyond.share > kFewBeyond && beyond.distance > least) findings.push_back(over_the_edge(tool, beyond));
  }
  return findings;
}

}  // namespace diefill::process
