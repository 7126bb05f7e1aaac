#include "process/estimate/openings/openings.h"

#include <algorithm>
#include <cmath>

#include "process/estimate/openings/motion_times.h"
#include "process/tooling/examination/plan_view.h"
#include "process/tooling/stages.h"

namespace diefill::process::estimate {

namespace {

constexpr double kJustBelow = 2e-4;  // m below the fill plane, where openings are taken
constexpr double kPlaces = 2500;     // wanted in all openings together
constexpr double kMaxWork = 2e7;     // places times pieces of outline
constexpr double kMinFall = 5e-4;    // m, that a punch must go down
constexpr double kBeside = 2e-4;     // m, to which the box of a cavity is exact
constexpr double kMaxRows = 2000;    // slivers beside a tool have next to no area, and would want more
constexpr int kFirstRows = 60, kDense = 200;

/// The tool seen from the die at `time`.
ToolPose pose_in_die(const Tooling& tooling, const Stages& stages, const std::vector<StepState>& states,
                     const std::string& tool, double time) {
  const ToolPose below = pose_of(stages, states, tooling.tools[tooling.die].spec.name, time);
  const ToolPose above = pose_of(stages, states, tool, time);
  ToolPose pose;
  pose.rotation = below.rotation.transpose() * above.rotation;
  pose.translation = below.rotation.transpose() * (above.translation - below.translation);
  return pose;
}

bool at_initial_pose(const ToolPose& pose) {
  return pose.rotation.isIdentity(1e-9) && pose.translation.norm() < 1e-9;
}

geometry::Mesh placed(const geometry::Mesh& mesh, const ToolPose& pose) {
  return at_initial_pose(pose) ? mesh : geometry::transformed(mesh, pose.rotation, pose.translation);
}

/// m, the box that openings are looked for in.
geometry::Box region_of(const Scene& scene, const Tooling& tooling) {
  geometry::Box box =
      tooling.cavity.found ? tooling.all_cavities().box : tooling.tools[tooling.die].mesh.bounding_box();
  for (Eigen::Index axis = 0; axis < 2; ++axis)
    if (const auto& period = scene.numerics.period[static_cast<std::size_t>(axis)]) {
      box.lower[axis] = std::max(box.lower[axis], -0.5 * *period);
      box.upper[axis] = std::min(box.upper[axis], 0.5 * *period);
    }
  return box;
}

/// Places on rows `step` m apart.
std::vector<OpeningPatch> places_on_rows(const Outline& outline, const geometry::Box& box, double step) {
  std::vector<OpeningPatch> places;
  const int rows = std::max(1, static_cast<int>(std::ceil(box.size().y() / step)));
  const double apart = box.size().y() / rows;
  for (int j = 0; j < rows; ++j) {
    const double y = box.lower.y() + (j + 0.5) * apart;
    for (const auto& [begin, end] : outline.gaps(y)) {
      const double from = std::max(begin, box.lower.x()), to = std::min(end, box.upper.x());
      if (to <= from) continue;
      const int cells = std::max(1, static_cast<int>(std::ceil((to - from) / step)));
      const double long_each = (to - from) / cells;
      for (int i = 0; i < cells; ++i) {
        OpeningPatch place;
        place.at = {from + (i + 0.5) * long_each, y};
        place.area = long_each * apart;
        places.push_back(place);
      }
    }
  }
  return places;
}

double area_of(const std::vector<OpeningPatch>& places) {
  double area = 0;
  for (const auto& place : places) area += place.area;
  return area;
}

/// Sets the width of every place: twice the largest distance to a wall of a place in whose circle it lies.
void measure_widths(const Outline& outline, std::vector<OpeningPatch>& places) {
  std::vector<double> distance;
  for (const auto& place : places) distance.push_back(outline.distance(place.at));
  for (auto& place : places)
    for (std::size_t k = 0; k < places.size(); ++k)
      if (2 * distance[k] > place.width && (places[k].at - place.at).norm() <= distance[k])
        place.width = 2 * distance[k];
}

bool holds(const geometry::Box& box, const Eigen::Vector2d& place, double beside) {
  return (place.array() >= box.lower.head<2>().array() - beside).all() &&
         (place.array() <= box.upper.head<2>().array() + beside).all();
}

/// Which cavity lies below a place: the smallest whose box holds it, or else the first that is no farther
/// beside it than boxes are exact; nothing where none is, as over a gap between two tools.
std::optional<std::size_t> cavity_below(const std::vector<geometry::Cavity>& cavities,
                                        const Eigen::Vector2d& place) {
  for (std::size_t k = cavities.size(); k-- > 0;)
    if (holds(cavities[k].box, place, 0)) return k;  // by falling volume: the last is the smallest
  for (std::size_t k = 0; k < cavities.size(); ++k)
    if (holds(cavities[k].box, place, kBeside)) return k;
  return std::nullopt;
}

FillOpening opening_of(const geometry::Cavity& cavity) {
  FillOpening opening;
  opening.is_cavity = true;
  opening.volume = cavity.volume;
  opening.narrowest = cavity.narrowest_width;
  opening.centre = cavity.axis_origin.head<2>();
  return opening;
}

/// Gives every place its cavity, drops those that have none, and sums up what the openings are.
void sum_up(const Tooling& tooling, OpeningLayout& layout) {
  std::vector<geometry::Cavity> cavities;
  if (tooling.cavity.found) cavities.push_back(tooling.cavity);
  cavities.insert(cavities.end(), tooling.other_cavities.begin(), tooling.other_cavities.end());
  for (const auto& cavity : cavities) layout.openings.push_back(opening_of(cavity));
  if (cavities.empty()) layout.openings.emplace_back();
  std::erase_if(layout.places, [&](OpeningPatch& place) {
    const auto below = cavities.empty() ? 0 : cavity_below(cavities, place.at);
    if (below) place.opening = *below;
    return !below;
  });
  for (const auto& place : layout.places) {
    FillOpening& opening = layout.openings[place.opening];
    opening.area += place.area;
    opening.width += place.area * place.width;
  }
  for (auto& opening : layout.openings)
    if (opening.area > 0) opening.width /= opening.area;
}

/// The fall of one tool in the die, if it is one.
std::optional<FallingPunch> fall_of(const Tooling& tooling, const Stages& stages,
                                    const std::vector<StepState>& states, const std::vector<double>& times,
                                    const Tool& tool) {
  constexpr double kSmallestMove = 1e-5;  // m, from which on a punch has left its end position
  const auto height = [&](double time) {
    return pose_in_die(tooling, stages, states, tool.spec.name, time).translation.z();
  };
  const double first = height(times.front()), last = height(times.back());
  if (first - last < kMinFall) return std::nullopt;
  FallingPunch fall;
  fall.tool = tool.spec.name;
  fall.stroke = first - last;
  fall.began = times.front();
  for (const double time : times)
    if (height(time) > first - kSmallestMove) fall.began = time;
  fall.ended = times.back();
  for (auto time = times.rbegin(); time != times.rend() && height(*time) < last + kSmallestMove; ++time)
    fall.ended = *time;
  return fall;
}

/// A punch that falls, with its top as the steps leave it.
struct FallenPunch {
  FallingPunch fall;
  geometry::Mesh mesh;
  double top = 0;  ///< m
};

/// Tools that go down in the die and end below the fill plane, the highest first.
std::vector<FallenPunch> fallen_punches(const Scene& scene, const Tooling& tooling) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  const auto times = motion_times(stages, states, kDense);
  std::vector<FallenPunch> fallen;
  const bool die_moves = stages.moves(tooling.tools[tooling.die].spec.name);
  for (const Tool& tool : tooling.tools) {
    if (tool.spec.role == ToolRole::shoe || &tool == &tooling.tools[tooling.die]) continue;
    if (!die_moves && !stages.moves(tool.spec.name)) continue;
    const auto fall = fall_of(tooling, stages, states, times, tool);
    if (!fall || !(fall->ended > fall->began)) continue;
    FallenPunch punch = {
        *fall, placed(tool.mesh, pose_in_die(tooling, stages, states, tool.spec.name, times.back()))};
    punch.top = punch.mesh.bounding_box().upper.z();
    if (punch.top < tooling.fill_plane) fallen.push_back(std::move(punch));
  }
  std::sort(fallen.begin(), fallen.end(),
            [](const auto& one, const auto& other) { return one.top > other.top; });
  return fallen;
}

/// Finds the punches that fall, and which places they open. A punch hides what lies below it.
void find_falls(const Scene& scene, const Tooling& tooling, OpeningLayout& layout) {
  if (!tooling.cavity.found) return;
  for (FallenPunch& punch : fallen_punches(scene, tooling)) {
    const PlanView view(punch.mesh, punch.top - kJustBelow);
    const bool fills_the_opening = punch.top + punch.fall.stroke > tooling.fill_plane - kMinFall;
    for (auto& place : layout.places) {
      if (place.punch || !view.solid(place.at)) continue;
      place.punch = layout.punches.size();
      if (fills_the_opening) place.opens = punch.fall.began;
      punch.fall.area += place.area;
      punch.fall.opening = place.opening;
    }
    if (punch.fall.area > 0) layout.punches.push_back(punch.fall);
  }
}

}  // namespace

OpeningLayout find_openings(const Scene& scene, const Tooling& tooling) {
  OpeningLayout layout;
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  const auto times = motion_times(stages, states, kDense);
  const double end = times.empty() ? 0 : times.back();
  for (const Tool& tool : tooling.tools)
    if (tool.spec.role != ToolRole::shoe)
      layout.outline.add(placed(tool.mesh, pose_in_die(tooling, stages, states, tool.spec.name, end)),
                         tooling.fill_plane - kJustBelow);
  const geometry::Box box = region_of(scene, tooling);
  if (layout.outline.empty() || (box.size().head<2>().array() <= 0).any()) return layout;
  const double area = area_of(places_on_rows(layout.outline, box, box.size().y() / kFirstRows));
  if (!(area > 0)) return layout;
  const double wanted =
      std::clamp(kMaxWork / static_cast<double>(layout.outline.size()), kPlaces / 10, kPlaces);
  const double step = std::max(std::sqrt(area / wanted), box.size().head<2>().maxCoeff() / kMaxRows);
  layout.places = places_on_rows(layout.outline, box, step);
  measure_widths(layout.outline, layout.places);
  sum_up(tooling, layout);
  find_falls(scene, tooling, layout);
  return layout;
}

double narrowest_hole(const Scene& scene, const Tooling& tooling) {
  double narrowest = 0;
  for (const FillOpening& opening : find_openings(scene, tooling).openings)
    if (!opening.is_cavity && (narrowest == 0 || opening.width < narrowest)) narrowest = opening.width;
  return narrowest;
}

}  // namespace diefill::process::estimate
