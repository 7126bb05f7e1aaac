// One CAD tool as the scene describes it: its role, its file, where it stands and what its surface is.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "geometry/mesh/mesh_repair.h"

namespace diefill::process {

struct PairLawSpec;

/// What a tool's surface is to the powder: covered with wall spheres, or the CAD mesh itself, the yardstick
/// for them.
enum class WallKind { spheres, mesh };

enum class ToolRole { die, core, punch, shoe, plate };

/// The role as the scene spells it, such as "shoe".
std::string description(ToolRole role);

/// One CAD tool of the scene.
struct ToolSpec {
  std::string name;
  ToolRole role = ToolRole::die;
  std::filesystem::path file;  ///< absolute or relative to the scene file, already resolved
  std::string part;            ///< of the file; empty: all parts as one tool
  double metres_per_unit = 0;  ///< from `length_unit`; 0: the file states it
  Eigen::Vector3d mirror = Eigen::Vector3d::Zero();  ///< normal of the mirror; zero: none. Applied first
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< applied to the CAD then
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< m, then shifted
  std::optional<double> chord_tolerance;  ///< m, for curved surfaces; a hundredth of the wall spheres' radius
  geometry::RepairLevel repair = geometry::RepairLevel::kSafe;
  std::optional<WallKind> walls;                     ///< override of WallSpec::kind
  std::optional<double> sphere_radius, spacing;      ///< overrides of WallSpec
  std::optional<double> friction, work_of_adhesion;  ///< the same
  /// Law of its contact with the powder, where it differs from that of [contact.walls].
  std::shared_ptr<const PairLawSpec> contact;
  int line = 0;  ///< in the scene file, for messages
};

}  // namespace diefill::process
