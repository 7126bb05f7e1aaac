#include "process/setup/reachable_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "process/machine/actions/powder_inflow.h"
#include "process/tooling/stages.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

namespace {

using Poses = std::vector<ToolPose>;

constexpr int kInstants = 2000;  ///< of a step that are looked at
constexpr double kThrown = 0.1;  ///< over d: powder thrown up no higher stays where it is

/// The largest of `of(corner)` over the corners of the box.
template <class Of>
double largest_of_corners(const geometry::Box& box, const Of& of) {
  double largest = 0;
  for (int corner = 0; corner < 8; ++corner)
    largest = std::max(largest, of(Eigen::Vector3d((corner & 1) != 0 ? box.upper[0] : box.lower[0],
                                                   (corner & 2) != 0 ? box.upper[1] : box.lower[1],
                                                   (corner & 4) != 0 ? box.upper[2] : box.lower[2])));
  return largest;
}

/// m, how far any corner of the box is apart in two poses.
double distance_between(const geometry::Box& box, const ToolPose& one, const ToolPose& other) {
  return largest_of_corners(box, [&](const Eigen::Vector3d& corner) {
    return ((one.rotation - other.rotation) * corner + one.translation - other.translation).norm();
  });
}

/// m/s, fastest that a corner of the box becomes in a step of `length` (s).
double top_speed(const Step& step, double length, const geometry::Box& box) {
  double fastest = 0;
  for (int n = 0; n <= kInstants; ++n) {
    const ToolPose pose = compose(step.motion(length * n / kInstants), {});
    fastest = std::max(fastest, largest_of_corners(box, [&](const Eigen::Vector3d& corner) {
                         return (pose.velocity + pose.angular_velocity.cross(pose.rotation * corner)).norm();
                       }));
  }
  return fastest;
}

/// m, how high powder flies from tools that are shaken or turned, other than shoes, which keep theirs: with
/// twice their speed, as grains do that meet them head-on.
double throw_height(const Scene& scene, const Tooling& tooling) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  double speed = 0;
  for (std::size_t s = 0; s < stages.size(); ++s) {
    const Step& step = *stages.steps[s];
    if (!step.stays() || step.control() != nullptr) continue;
    for (const std::string& name : step.tools()) {
      const Tool& tool = tooling.tools[tooling.index_of(name)];
      if (tool.spec.role == ToolRole::shoe) continue;
      speed = std::max(speed, top_speed(step, states[s].ended - states[s].started, tool.mesh.bounding_box()));
    }
  }
  constexpr double kWeakest = 1;  // m/s^2: without gravity nothing brings back what is thrown
  return 2 * speed * speed / std::max(kWeakest, scene.gravity.norm());
}

double largest_distance(const Tooling& tooling, const Poses& one, const Poses& other) {
  double farthest = 0;
  for (std::size_t k = 0; k < one.size(); ++k)
    farthest = std::max(farthest, distance_between(tooling.tools[k].mesh.bounding_box(), one[k], other[k]));
  return farthest;
}

/// Of a step that moves tools about their place, the two instants when they are farthest apart.
std::array<double, 2> extremes(const Step& step, const StepState& state, const geometry::Box& box) {
  const double length = state.ended - state.started;
  const auto farthest_from = [&](const ToolPose& pose) {
    double best = 0, farthest = -1;
    for (int n = 0; n <= kInstants; ++n) {
      const double time = length * n / kInstants;
      const double distance = distance_between(box, compose(step.motion(time), {}), pose);
      if (distance > farthest) {
        farthest = distance;
        best = time;
      }
    }
    return best;
  };
  const double one = farthest_from({});
  return {state.started + one, state.started + farthest_from(compose(step.motion(one), {}))};
}

/// Poses of all tools as time goes on: at the start, then whenever one has moved on by `distance`, at the end
/// of every step, and where shaken tools are farthest out. Fine in time first, so that a passage there and
/// back is sampled once a way.
std::vector<Poses> sampled_poses(const Scene& scene, const Tooling& tooling, double distance) {
  const Stages stages(scene);
  const auto states = predicted(stages, kSettlingGuess);
  auto times = instants(stages, states, kInstants);
  std::set<double> wanted;
  for (std::size_t s = 0; s < stages.size(); ++s) {
    const Step& step = *stages.steps[s];
    if (step.tools().empty()) continue;
    wanted.insert(states[s].ended);
    if (!step.stays() || step.control() != nullptr) continue;
    const auto& tool = tooling.tools[tooling.index_of(step.tools().front())];
    for (const double time : extremes(step, states[s], tool.mesh.bounding_box())) wanted.insert(time);
  }
  times.insert(times.end(), wanted.begin(), wanted.end());
  std::sort(times.begin(), times.end());
  std::vector<Poses> samples(1, Poses(tooling.tools.size()));
  for (const double time : times) {
    Poses poses;
    for (const auto& tool : tooling.tools) poses.push_back(pose_of(stages, states, tool.spec.name, time));
    const double moved = largest_distance(tooling, poses, samples.back());
    if (moved >= distance || (moved > 0 && wanted.contains(time))) samples.push_back(std::move(poses));
  }
  return samples;
}

/// Where powder is poured, then where it comes in later: at the start, as tools carry it on from there. Boxes
/// of inflows may be flat: they are made wider by `voxel` (m) on all sides.
std::vector<geometry::Box> powder_boxes(const Scene& scene, double voxel) {
  std::vector<geometry::Box> boxes = {{scene.pour.lower, scene.pour.upper}};
  const Eigen::Vector3d wider = Eigen::Vector3d::Constant(voxel);
  for (const auto& step : scene.steps)
    if (const PowderInflow* inflow = step->inflow())
      boxes.push_back({inflow->lower - wider, inflow->upper + wider});
  return boxes;
}

/// Edge of the voxels, m: a quarter of a grain, fine enough for walls, coarse enough for a scene of a few
/// hundred millimetres.
double voxel_edge(const Tooling& tooling, double grain_diameter) {
  constexpr double kMaxVoxels = 2e7;
  const double of_grains = 0.25 * grain_diameter;
  double voxel = std::max(of_grains, std::cbrt(tooling.all.size().prod() / kMaxVoxels));
  voxel = std::clamp(voxel, 1e-5, std::max(5e-4, of_grains));
  // Wider where tools are far apart: powder does not come through openings half a grain wide.
  constexpr double kManyVoxels = 1e8;
  const double for_many = std::cbrt(tooling.standing.size().prod() / kManyVoxels);
  return for_many > voxel ? std::max(voxel, std::min(for_many, 0.5 * grain_diameter)) : voxel;
}

/// What is searched: the standing tools, and above them as high as powder comes.
geometry::Box searched(const geometry::ReachRequest& request, const Tooling& tooling) {
  geometry::Box domain = tooling.standing;
  domain.upper[2] = tooling.all.upper[2];
  for (const geometry::Box& box : request.powder) domain.upper[2] = std::max(domain.upper[2], box.upper[2]);
  domain.upper[2] += request.climb;
  return domain;
}

/// The tools in all poses that matter.
std::vector<geometry::MovingSolid> moving_solids(const Scene& scene, const Tooling& tooling) {
  const auto samples = sampled_poses(scene, tooling, 0.25 * tooling.all.size().head<2>().maxCoeff() / 8);
  std::vector<geometry::MovingSolid> solids;
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) {
    geometry::MovingSolid solid;
    solid.mesh = &tooling.tools[k].mesh;
    for (const auto& sample : samples) {
      solid.rotations.push_back(sample[k].rotation);
      solid.translations.push_back(sample[k].translation);
    }
    solids.push_back(std::move(solid));
  }
  return solids;
}

geometry::ReachRequest request_of(const Scene& scene, const Tooling& tooling, double grain_diameter) {
  geometry::ReachRequest request;
  request.voxel = voxel_edge(tooling, grain_diameter);
  const double thrown = throw_height(scene, tooling);
  request.scatters = thrown > kThrown * grain_diameter;
  request.climb = 2 * grain_diameter + (request.scatters ? thrown : 0);
  request.powder = powder_boxes(scene, request.voxel);
  request.domain = searched(request, tooling);
  request.solids = moving_solids(scene, tooling);
  return request;
}

}  // namespace

ReachableSurface::ReachableSurface(const Scene& scene, const Tooling& tooling, double grain_diameter) {
  geometry::ReachRequest request = request_of(scene, tooling, grain_diameter);
  // Flooded voxels are free space up to the walls: the answer is uncertain only by their size. The margin is
  // wide enough to close the ragged border of the flooded space: an extra strip of wall costs little, a gap
  // loses grains.
  margin_ = 2 * request.voxel + 0.5 * grain_diameter;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& period = scene.numerics.period[axis];
    period_half_[axis] = period ? 0.5 * *period : std::numeric_limits<double>::infinity();
    const auto a = static_cast<Eigen::Index>(axis);
    request.domain.lower[a] = std::max(request.domain.lower[a], -period_half_[axis]);
    request.domain.upper[a] = std::min(request.domain.upper[a], period_half_[axis]);
  }
  if (scene.pour.around_tools) {
    falls_here_ = request.powder.front();
    falls_here_.lower.array() -= margin_;
    falls_here_.upper.array() += margin_;
    falls_here_.upper[2] = std::max(falls_here_.upper[2], tooling.all.upper[2] + margin_);
  }
  try {
    reach_ = std::make_unique<geometry::Reach>(request);
  } catch (const geometry::MeshError& error) {
    throw SceneError(scene.file.string() + ": " + error.what());
  }
}

bool ReachableSurface::operator()(std::size_t tool, const Eigen::Vector3d& point,
                                  const Eigen::Vector3d& normal) const {
  // Powder poured round tools comes down on all that stands in its way, above rims too.
  if (falls_here_.contains(point)) return true;
  // Along a period every place is like every other: ask well inside the flooded box.
  Eigen::Vector3d asked = point;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double inside = 0.9 * period_half_[axis];
    asked[axis] = std::clamp(point[axis], -inside, inside);
  }
  return reach_->reachable(tool, asked, normal, margin_);
}

}  // namespace diefill::process
