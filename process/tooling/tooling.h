// The tools of a scene, ready for the engine: CAD read and examined, cavity found, reachable surfaces covered
// with wall spheres.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/cavity/cavity.h"
#include "geometry/mesh/mesh_check.h"
#include "geometry/solid/solid_query.h"
#include "geometry/wall_spheres/wall_spheres.h"
#include "process/scene/scene.h"
#include "process/tooling/progress.h"

namespace diefill::process {

/// One tool. The mesh is in the laboratory frame at the scene's start; the tool's body frame is that same
/// frame.
struct Tool {
  ToolSpec spec;
  geometry::Mesh mesh;
  geometry::MeshFindings found;           ///< as the file has it
  geometry::MeshFindings findings;        ///< after repair
  std::vector<std::string> file_remarks;  ///< oddities of the file that were ignored
  std::vector<std::string> repairs;       ///< one per line; empty when nothing was done
  std::vector<std::string> not_repaired;  ///< what would have been a guess
  std::vector<std::string> file_parts;    ///< names of the parts in the file
  double metres_per_unit = 0;             ///< of the file
  bool unit_from_file = false;
  std::optional<double> chord_tolerance;  ///< m, where the triangles stand for curved surfaces
  std::string file_hash;
  geometry::WallSpheres spheres;
  /// The wall itself, where that is the mesh; `spheres` then only cut the cells of grains that measures take.
  std::optional<geometry::Mesh> wall_mesh;

  /// Queries of `mesh`, built at first use: millions of triangles take seconds and a gigabyte.
  const geometry::SolidQuery& solid() const;
  /// Keeps the adjacency that a check of `mesh` found for solid(), which would find it again.
  void keep(geometry::Topology topology) { topology_ = std::move(topology); }

 private:
  // Only one thread may make the first call.
  mutable std::optional<geometry::SolidQuery> solid_;
  mutable std::optional<geometry::Topology> topology_;  ///< until solid() takes it
};

struct Tooling {
  std::vector<Tool> tools;
  std::size_t die = 0;    ///< index of the part that powder is collected in: the die, else the first no shoe
  double fill_plane = 0;  ///< m, height that cavities lie below
  geometry::Cavity cavity;  ///< the largest, in the frame of results, as the scene's steps leave the tools
  std::vector<geometry::Cavity> other_cavities;  ///< by falling volume
  geometry::Box standing;     ///< m, box round the tools that stay at their place and the room they need
  geometry::Box all;          ///< m, box round all tools at the start
  std::optional<int> mirror;  ///< axis at right angles to the mirror plane of a half model
  /// The scene's steps with what they left to the geometry settled (Step::prepared).
  std::vector<std::shared_ptr<const Step>> steps;

  std::size_t wall_spheres() const;
  /// Whether the scene has a die, whose frame results are then in.
  bool has_die() const { return tools[die].spec.role == ToolRole::die; }
  /// All cavities as one, for motions and planning: the largest with the box and the volume of all and the
  /// narrowest place of any.
  geometry::Cavity all_cavities() const;
  /// Oddities of the tools' files, repairs of their CAD, and files that were used as a whole:
  /// a line each.
  std::vector<std::string> remarks() const;
  /// Index of the tool of that name. Throws std::out_of_range.
  std::size_t index_of(const std::string& name) const;
};

/// Reads one tool, repairs it as far as its scene allows, and places it. Throws SceneError or
/// geometry::MeshError when its file cannot be read; whether the mesh is usable is in `findings`.
Tool read_tool(const Scene& scene, const ToolSpec& spec);

/// Throws SceneError when the tool's mesh encloses no solid.
void refuse_unusable(const Scene& scene, const Tool& tool);

/// The scene as a run with these tools follows it, which is what all that moves them takes.
Scene with_prepared_steps(Scene scene, const Tooling& tooling);

/// The tool's motion in a step as an engine pose of its body frame.
struct ToolPose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();       ///< m
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< m/s, of the frame's origin
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< rad/s
};

/// `motion` on top of `before`, where other steps take the tool at the same time.
ToolPose compose(const ToolMotion& motion, const ToolPose& before);

/// The cavities below the fill plane between the tools in the given poses, the largest first: in the frame of
/// the die, as if that stood where the scene puts it, or without a die in the laboratory frame.
std::vector<geometry::Cavity> cavities_between(const Tooling& tooling, const std::vector<ToolPose>& poses);
/// The largest of them, or one that says that there is none.
geometry::Cavity cavity_between(const Tooling& tooling, const std::vector<ToolPose>& poses);

/// m, of the wall spheres that cover this tool.
double wall_sphere_radius(const Scene& scene, const ToolSpec& spec);

/// s, guess for the time powder needs to come to rest; for planning and progress only.
inline constexpr double kSettlingGuess = 0.25;

}  // namespace diefill::process
