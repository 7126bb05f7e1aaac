#include "process/tooling/tool_paths.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unordered_set>

#include "engine/numerics/fnv1a.h"
#include "engine/numerics/out_of_range.h"
#include "engine/simulation/simulation.h"
#include "process/machine/free_motion.h"
#include "process/tooling/stages.h"

namespace diefill::process {

namespace {

constexpr double kStep = 5e-4;       // m, that tools move from pose to pose at most
constexpr int kDense = 200;          // instants of a step to begin with
constexpr int kHalvings = 8;         // of the time between two of them
constexpr double kThinShare = 0.25;  // of a sheet's thickness
constexpr double kSameShift = 1e-5;  // m
constexpr double kSameTurn = 1e-4;
constexpr std::size_t kAfterFirst = 8;  // of so many poses one is looked at once a collision is known

using Poses = std::vector<ToolPose>;

geometry::SolidPose solid_pose(const ToolPose& pose) {
  return {pose.rotation, pose.translation};
}

/// m, farthest that a corner of the box moves.
double farthest_move(const geometry::Box& box, const ToolPose& from, const ToolPose& to) {
  double farthest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d point((corner & 1) != 0 ? box.upper[0] : box.lower[0],
                                (corner & 2) != 0 ? box.upper[1] : box.lower[1],
                                (corner & 4) != 0 ? box.upper[2] : box.lower[2]);
    farthest = std::max(farthest,
                        ((to.rotation - from.rotation) * point + to.translation - from.translation).norm());
  }
  return farthest;
}

bool is_free(const Stages& stages, const std::string& tool) {
  return std::ranges::any_of(stages.steps, [&](const auto& step) {
    return free_motion_of(*step) != nullptr && step->tools().front() == tool;
  });
}

/// All tools as time goes on, so close that none moves farther than kStep from one to the next.
class Way {
 public:
  Way(const Scene& scene, const Tooling& tooling, ForcedTools forced)
      : tooling_(tooling), forced_(forced), stages_(scene) {
    states_ = predicted(stages_, kSettlingGuess);
    if (forced == ForcedTools::stand)
      for (auto& state : states_) state.control = {};
    for (const Tool& tool : tooling.tools) boxes_.push_back(tool.mesh.bounding_box());
    times_.push_back(0);
    poses_.push_back(poses_at(0));
    for (const double time : instants(stages_, states_, kDense)) go_to(time, poses_at(time), kHalvings);
  }
  const std::vector<double>& times() const { return times_; }
  const std::vector<Poses>& poses() const { return poses_; }
  const Stages& stages() const { return stages_; }
  const std::vector<StepState>& states() const { return states_; }

 private:
  Poses poses_at(double time) const {
    Poses poses;
    for (const Tool& tool : tooling_.tools)
      poses.push_back(forced_ == ForcedTools::stand && is_free(stages_, tool.spec.name)
                          ? ToolPose()
                          : pose_of(stages_, states_, tool.spec.name, time));
    return poses;
  }
  void go_to(double time, const Poses& poses, int halvings) {
    double farthest = 0;
    for (std::size_t k = 0; k < poses.size(); ++k)
      farthest = std::max(farthest, farthest_move(boxes_[k], poses_.back()[k], poses[k]));
    if (farthest > kStep && halvings > 0) {
      const double middle = 0.5 * (times_.back() + time);
      go_to(middle, poses_at(middle), halvings - 1);
      go_to(time, poses, halvings - 1);
      return;
    }
    times_.push_back(time);
    poses_.push_back(poses);
  }

  const Tooling& tooling_;
  ForcedTools forced_;
  Stages stages_;
  std::vector<StepState> states_;
  std::vector<geometry::Box> boxes_;
  std::vector<double> times_;
  std::vector<Poses> poses_;
};

/// The step that moves one of the tools at `time`; the last begun of several.
std::size_t step_at(const Way& way, const std::string& one, const std::string& other, double time) {
  std::size_t found = 0;
  for (std::size_t k = 0; k < way.stages().size(); ++k) {
    const auto tools = way.stages().steps[k]->tools();
    const bool moves = std::any_of(tools.begin(), tools.end(),
                                   [&](const std::string& tool) { return tool == one || tool == other; });
    if (moves && !way.states()[k].is_pending() && way.states()[k].started <= time) found = k;
  }
  return found;
}

/// Where the two are to each other, up to rounding.
std::uint64_t relative_place(const ToolPose& one, const ToolPose& other) {
  const Eigen::Matrix3d turn = other.rotation.transpose() * one.rotation;
  const Eigen::Vector3d shift = other.rotation.transpose() * (one.translation - other.translation);
  engine::Fnv1a hash;
  for (Eigen::Index i = 0; i < 3; ++i) hash.add_number(std::llround(shift[i] / kSameShift));
  for (Eigen::Index i = 0; i < 9; ++i) hash.add_number(std::llround(turn(i / 3, i % 3) / kSameTurn));
  return hash.value();
}

std::optional<ToolCollision> collision_of(const Scene& scene, const Tooling& tooling, const Way& way,
                                          std::size_t one, std::size_t other) {
  const Tool &first = tooling.tools[one], &second = tooling.tools[other];
  geometry::MovingPair pair(first.mesh, first.solid(), second.mesh, second.solid(),
                            allowed_depth(scene, first, second));
  std::unordered_set<std::uint64_t> known;
  std::optional<ToolCollision> found;
  for (std::size_t n = 0; n < way.poses().size(); ++n) {
    const ToolPose &here = way.poses()[n][one], &there = way.poses()[n][other];
    if (!known.insert(relative_place(here, there)).second) continue;
    if (found && known.size() % kAfterFirst != 0) continue;
    const auto cut = pair.find_cut(solid_pose(here), solid_pose(there));
    if (!cut) continue;
    if (!found) {
      const std::size_t step = step_at(way, first.spec.name, second.spec.name, way.times()[n]);
      found = ToolCollision{first.spec.name,
                            second.spec.name,
                            way.stages().steps[step]->plan.where,
                            way.times()[n] - way.states()[step].started,
                            cut->depth,
                            0,
                            cut->place};
    }
    found->deepest = std::max(found->deepest, cut->depth);
  }
  return found;
}

bool under_force(const Scene& scene, const std::string& tool) {
  return std::any_of(scene.steps.begin(), scene.steps.end(), [&](const auto& step) {
    const auto tools = step->tools();
    return (step->control() != nullptr || free_motion_of(*step) != nullptr) &&
           std::find(tools.begin(), tools.end(), tool) != tools.end();
  });
}

}  // namespace

std::string ToolCollision::description() const {
  char text[320];
  std::snprintf(text, sizeof text,
                "tool \"%s\" penetrates tool \"%s\" %.4g s after the step begins, near (%.2f, %.2f, %.2f) "
                "mm, up to %.3g mm deep",
                one.c_str(), other.c_str(), since, 1e3 * place[0], 1e3 * place[1], 1e3 * place[2],
                1e3 * deepest);
  return text;
}

double allowed_depth(const Scene& scene, const Tool& one, const Tool& other) {
  const double radius = std::max(one.spec.sphere_radius.value_or(scene.walls.sphere_radius),
                                 other.spec.sphere_radius.value_or(scene.walls.sphere_radius));
  return std::min({radius, kThinShare * geometry::mean_thickness(one.mesh),
                   kThinShare * geometry::mean_thickness(other.mesh)});
}

std::vector<ToolCollision> find_collisions(const Scene& scene, const Tooling& tooling, ForcedTools forced) {
  std::vector<ToolCollision> collisions;
  const Stages stages(scene);
  const auto moves = [&](std::size_t k) { return stages.moves(tooling.tools[k].spec.name); };
  std::optional<Way> way;
  for (std::size_t one = 0; one < tooling.tools.size(); ++one)
    for (std::size_t other = 0; other < one; ++other) {
      if (!moves(one) && !moves(other)) continue;
      if (!way) way.emplace(scene, tooling, forced);
      const bool mover_first = moves(one);
      auto found = mover_first ? collision_of(scene, tooling, *way, one, other)
                               : collision_of(scene, tooling, *way, other, one);
      if (found) collisions.push_back(std::move(*found));
    }
  return collisions;
}

void refuse_collisions(const Scene& scene, const Tooling& tooling) {
  auto collisions = find_collisions(scene, tooling, ForcedTools::stand);
  if (collisions.empty()) return;
  std::string message = collisions.front().where.empty() ? scene.file.string() : collisions.front().where;
  for (std::size_t k = 0; k < collisions.size(); ++k)
    message += (k == 0 ? ": " : "; ") + collisions[k].description();
  throw ToolsCollide(message + "; change the motion or move one of the tools", std::move(collisions));
}

ForcedToolWatch::ForcedToolWatch(const Scene& scene, const Tooling& tooling) : tooling_(tooling) {
  for (std::size_t one = 0; one < tooling.tools.size(); ++one)
    for (std::size_t other = 0; other < one; ++other) {
      const Tool &first = tooling.tools[one], &second = tooling.tools[other];
      if (!under_force(scene, first.spec.name) && !under_force(scene, second.spec.name)) continue;
      pairs_.push_back(
          {one, other,
           std::make_unique<geometry::MovingPair>(first.mesh, first.solid(), second.mesh, second.solid(),
                                                  allowed_depth(scene, first, second))});
    }
}

void ForcedToolWatch::check(const engine::Simulation& simulation) {
  for (Pair& pair : pairs_) {
    const auto &one = simulation.body_motion(pair.one), &other = simulation.body_motion(pair.other);
    const auto cut =
        pair.solids->find_cut({one.rotation, one.translation}, {other.rotation, other.translation});
    if (!cut) continue;
    char text[400];
    std::snprintf(text, sizeof text,
                  "tool \"%s\" penetrates tool \"%s\" at t = %.6g s, %.3g mm deep near (%.2f, %.2f, %.2f) "
                  "mm: the powder does not stop it; reduce its travel",
                  tooling_.tools[pair.one].spec.name.c_str(), tooling_.tools[pair.other].spec.name.c_str(),
                  simulation.time(), 1e3 * cut->depth, 1e3 * cut->place[0], 1e3 * cut->place[1],
                  1e3 * cut->place[2]);
    throw engine::OutOfRange(text);
  }
}

}  // namespace diefill::process
