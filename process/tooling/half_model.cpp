#include "process/tooling/half_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "geometry/solid/symmetry.h"
#include "process/machine/force_control.h"

namespace diefill::process {

namespace {

constexpr double kSymmetryOverRadius = 0.2;  // as process/tooling/examination/diagnosis
constexpr std::uint64_t kFirstImage = std::uint64_t{1} << 32;
constexpr double kSameSphere = 1e-6;  // m per m of the grain, distance of two places that count as one
constexpr double kOutOfPlane = 1e-9;  // m, m/s, rad/s or none, what rounding makes of zero

Eigen::Vector3d image_of(Eigen::Vector3d place, int axis) {
  place[axis] = -place[axis];
  return place;
}

/// Spins and torques keep their part along the normal of the mirror and turn the others round.
Eigen::Vector3d image_of_spin(const Eigen::Vector3d& spin, int axis) {
  return -image_of(spin, axis);
}

/// Orientation of the image, whose spheres stand where M R o does for each offset o: with the grain's own
/// mirror plane N (offsets are a set that N leaves as it is) M R N is a rotation again. M is the rotation by
/// 180 degrees about `axis` times -1, and so is N about `own_axis`, so that M R N is a product of rotations.
Eigen::Vector4d image_of_turn(const Eigen::Vector4d& turn, int axis, int own_axis) {
  const auto half_turn = [](int about) {
    Eigen::Quaterniond half(0, 0, 0, 0);
    half.vec()[about] = 1;
    return half;
  };
  const Eigen::Quaterniond image =
      half_turn(axis) * Eigen::Quaterniond(turn[0], turn[1], turn[2], turn[3]) * half_turn(own_axis);
  return {-image.w(), -image.x(), -image.y(), -image.z()};
}

/// Axis of the body frame across which the spheres are mirror images of each other, `preferred` if it is one.
std::optional<int> own_mirror_axis(const std::vector<Eigen::Vector3d>& offsets,
                                   const std::vector<double>& radii, int preferred) {
  const auto is_mirrored = [&](int axis) {
    double size = 0;
    for (const auto& offset : offsets) size = std::max(size, offset.norm());
    for (std::size_t i = 0; i < offsets.size(); ++i) {
      const Eigen::Vector3d image = image_of(offsets[i], axis);
      bool found = false;
      for (std::size_t j = 0; j < offsets.size() && !found; ++j)
        found = (offsets[j] - image).norm() <= kSameSphere * size && (radii.empty() || radii[i] == radii[j]);
      if (!found) return false;
    }
    return true;
  };
  for (const int axis : {preferred, (preferred + 1) % 3, (preferred + 2) % 3})
    if (is_mirrored(axis)) return axis;
  return std::nullopt;
}

std::string plane_text(int axis) {
  return axis == 0 ? "x = 0" : "y = 0";
}

/// The same for each particle type; one for powder of one type.
std::vector<int> own_mirror_axes(const results::PowderState& powder, int preferred) {
  const results::ParticleTypes& kinds = powder.kinds;
  if (kinds.spheres.empty()) {
    const int axis =
        own_mirror_axis(powder.sphere_offsets, powder.sphere_radii, preferred).value_or(preferred);
    return std::vector<int>(std::max<std::size_t>(1, kinds.size()), axis);
  }
  std::vector<int> axes;
  auto offset = kinds.sphere_offsets.begin();
  auto radius = kinds.sphere_radii.begin();
  for (const std::uint32_t spheres : kinds.spheres) {
    axes.push_back(own_mirror_axis({offset, offset + spheres}, {radius, radius + spheres}, preferred)
                       .value_or(preferred));
    offset += spheres, radius += spheres;
  }
  return axes;
}

void refuse_asymmetric_tool(const Scene& scene, const Tool& tool, int axis) {
  const double tolerance = kSymmetryOverRadius * tool.spec.sphere_radius.value_or(scene.walls.sphere_radius);
  const auto symmetry = geometry::find_symmetry(tool.solid(), tolerance);
  const bool across = std::any_of(symmetry.planes.begin(), symmetry.planes.end(), [&](const auto& normal) {
    return std::abs(std::abs(normal[axis]) - 1) < 1e-6;
  });
  if (across && std::abs(symmetry.centre[axis]) <= tolerance) return;
  char text[200];
  std::snprintf(text, sizeof text,
                " is not symmetric across the plane %s within %.3g mm; remove the key, or choose the "
                "symmetry plane of the tools (diefill check prints it)",
                plane_text(axis).c_str(), 1e3 * tolerance);
  throw SceneError(scene.economy.mirror_place + ": tool \"" + tool.spec.name + "\"" + text);
}

bool lies_in_plane(const ToolMotion& motion, int axis) {
  Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
  mirror(axis, axis) = -1;
  Eigen::Vector3d turning = motion.angular_velocity;
  turning[axis] = 0;
  return std::abs(motion.translation[axis]) <= kOutOfPlane &&
         std::abs(motion.velocity[axis]) <= kOutOfPlane && turning.norm() <= kOutOfPlane &&
         (mirror * motion.rotation * mirror - motion.rotation).norm() <= kOutOfPlane;
}

/// Checks the motion at many irregularly spaced instants, so that no oscillation is missed between them.
bool step_lies_in_plane(const Step& step, int axis) {
  constexpr int kInstants = 2000;
  constexpr double kGoldenRatio = 0.6180339887498949, kOpenEnded = 1;  // s, long enough to see what it does
  constexpr double kFarEnough = 0.1;                                   // m or rad, to see where it goes
  if (const ForceControl* control = step.control())
    return lies_in_plane(control->motion(std::min(control->travel, kFarEnough), control->speed_limit), axis);
  const double length = step.open_ended() ? kOpenEnded : step.duration().value_or(kOpenEnded);
  for (int n = 1; n < kInstants; ++n)
    if (!lies_in_plane(step.motion(length * std::fmod(n * kGoldenRatio, 1.0)), axis)) return false;
  return true;
}

}  // namespace

void refuse_asymmetry(const Scene& scene, const Tooling& tooling) {
  if (!tooling.mirror) return;
  const int axis = *tooling.mirror;
  for (std::size_t k = 0; k <= scene.other_powders.size(); ++k)
    if (const auto& clump = powder_of(scene, k).clump;
        clump && !own_mirror_axis(clump->sphere_offsets, clump->sphere_radii, axis))
      throw SceneError(scene.economy.mirror_place + ": the grain of " +
                       (k == 0 ? "powder.spheres" : "powder \"" + powder_of(scene, k).label + "\"") +
                       " is not symmetric across a plane of its principal axes, so the other half would be "
                       "filled with its mirror image, another grain; remove the key");
  for (const Tool& tool : tooling.tools) refuse_asymmetric_tool(scene, tool, axis);
  for (const auto& step : scene.steps) {
    if (step->tools().empty() || step_lies_in_plane(*step, axis)) continue;
    throw SceneError(scene.economy.mirror_place + ": the step \"" + step->description() +
                     "\" moves a tool out of the mirror plane " + plane_text(axis) +
                     ", so the two halves are not mirror images; remove the key");
  }
}

void keep_near_half(const Scene& scene, geometry::WallSpheres& spheres) {
  if (!scene.economy.mirror) return;
  std::erase_if(spheres.centres,
                [&](const auto& centre) { return centre[*scene.economy.mirror] < -spheres.radius; });
}

engine::WallBodySpec mirror_wall(int axis) {
  engine::WallBodySpec wall;
  wall.name = "mirror plane";
  wall.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::Unit(axis)}};
  wall.mirror = true;
  return wall;
}

geometry::Box start_box(const Tooling& tooling, const PowderInflow& inflow, double radius) {
  geometry::Box box{inflow.lower, inflow.upper};
  if (!tooling.mirror) return box;
  const int axis = *tooling.mirror;
  box.lower[axis] = std::max(box.lower[axis], radius);
  box.upper[axis] = std::max(box.upper[axis], box.lower[axis]);
  return box;
}

double copies(const Tooling& tooling) {
  return tooling.mirror ? 2 : 1;
}

engine::WallLoad whole_load(const Tooling& tooling, const engine::WallLoad& load) {
  if (!tooling.mirror) return load;
  const int axis = *tooling.mirror;
  return {load.force + image_of(load.force, axis), load.torque + image_of_spin(load.torque, axis)};
}

void add_images(const Tooling& tooling, results::PowderState& powder) {
  if (!tooling.mirror) return;
  const int axis = *tooling.mirror;
  const std::size_t grains = powder.id.size();
  const bool several = !powder.monodisperse();
  const auto own_axis = own_mirror_axes(powder, axis);
  for (std::size_t k = 0; k < grains; ++k) {
    powder.id.push_back(kFirstImage + powder.id[k]);
    const std::size_t type = several ? powder.kind[k] : 0;
    if (several) powder.kind.push_back(powder.kind[k]);
    powder.position.push_back(image_of(powder.position[k], axis));
    powder.orientation.push_back(image_of_turn(powder.orientation[k], axis, own_axis[type]));
    powder.velocity.push_back(image_of(powder.velocity[k], axis));
    powder.angular_velocity.push_back(image_of_spin(powder.angular_velocity[k], axis));
  }
}

void add_images(const Tooling& tooling, results::ContactStress& stress) {
  if (!tooling.mirror) return;
  const int axis = *tooling.mirror;
  const std::size_t grains = stress.normal.size();
  for (std::size_t k = 0; k < grains; ++k) {
    stress.normal.push_back(stress.normal[k]);
    // Shear between the two axes in the plane stays, the others change sides.
    Eigen::Vector3d shear = -stress.shear[k];
    shear[axis] = stress.shear[k][axis];
    stress.shear.push_back(shear);
  }
}

void add_images(const Tooling& tooling, const results::PowderState& powder, results::Instant& instant) {
  if (!tooling.mirror) return;
  const int axis = *tooling.mirror;
  const auto own_axis = own_mirror_axes(powder, axis);
  const std::size_t grains = instant.id.size();
  const bool several = !instant.kind.empty();
  for (std::size_t k = 0; k < grains; ++k) {
    instant.id.push_back(kFirstImage + instant.id[k]);
    if (several) instant.kind.push_back(instant.kind[k]);
    instant.position.push_back(image_of(instant.position[k], axis));
    instant.orientation.push_back(
        image_of_turn(instant.orientation[k], axis, own_axis[several ? instant.kind[k] : 0]));
    instant.velocity.push_back(image_of(instant.velocity[k], axis));
  }
}

void add_images(const Tooling& tooling, std::vector<Eigen::Vector3d>& centres) {
  if (!tooling.mirror) return;
  const int axis = *tooling.mirror;
  // Spheres up to a radius beyond the plane are there already, each with its own image on this side.
  std::erase_if(centres, [axis](const auto& centre) { return centre[axis] < 0; });
  const std::size_t own = centres.size();
  for (std::size_t k = 0; k < own; ++k) centres.push_back(image_of(centres[k], axis));
}

}  // namespace diefill::process
