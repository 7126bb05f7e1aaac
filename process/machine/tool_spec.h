// One CAD tool as the scene describes it: role, file, position and surface.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "geometry/mesh/mesh_repair.h"

namespace diefill::process {

struct PairLawSpec;

/// What powder touches of a tool: wall spheres that cover its surface, or the triangles of its CAD mesh, the
/// reference for them.
enum class WallKind { spheres, mesh };

enum class ToolRole { die, core, punch, shoe, plate };

/// The role as the scene spells it, such as "shoe".
std::string description(ToolRole role);

/// One CAD tool of the scene.
struct ToolSpec {
  std::string name;
  ToolRole role = ToolRole::die;
  std::filesystem::path file;                              ///< relative paths of the scene are resolved
  std::string part;                                        ///< of the file; empty: all parts as one tool
  double metres_per_unit = 0;                              ///< from `length_unit`; 0: the file states it
  Eigen::Vector3d mirror = Eigen::Vector3d::Zero();        ///< normal of the mirror plane; zero: none. First
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< after the mirror
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< m, shift after the rotation
  std::optional<double> chord_tolerance;  ///< m, of curved surfaces; else 1 % of the wall spheres' radius
  geometry::RepairLevel repair = geometry::RepairLevel::kSafe;
  std::optional<WallKind> walls;                     ///< instead of WallSpec::kind
  std::optional<double> sphere_radius, spacing;      ///< m, instead of those of WallSpec
  std::optional<double> friction, work_of_adhesion;  ///< 1 and J/m^2, instead of those of WallSpec
  /// Law of its contact with the powder, where it differs from that of [contact.walls].
  std::shared_ptr<const PairLawSpec> contact;
  int line = 0;  ///< in the scene file, for messages
};

}  // namespace diefill::process
