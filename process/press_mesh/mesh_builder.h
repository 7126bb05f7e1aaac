// Gathers the nodes and elements of a mesh file by their numbers.
#pragma once

#include <string>
#include <unordered_map>

#include "process/press_mesh/mesh_lines.h"
#include "process/results/solid_mesh.h"

namespace diefill::process {

/// Lengths are multiplied by `unit` (m).
class MeshBuilder {
 public:
  MeshBuilder(const MeshLines& lines, double unit) : lines_(lines), unit_(unit) {}

  /// Coordinates in the file's unit. SceneError for a number that was given before.
  void add_node(std::uint64_t number, const Eigen::Vector3d& place);
  /// Nodes by their numbers, in the order of results::ElementShape. SceneError for a node that is not
  /// defined.
  void add_element(std::uint64_t number, results::ElementShape shape,
                   const std::vector<std::uint64_t>& nodes);
  void leave_out(std::size_t elements) { mesh_.left_out += elements; }

  /// Without nodes that no element uses. SceneError as check_solid_mesh.
  results::SolidMesh finish(const std::string& file);

 private:
  const MeshLines& lines_;
  double unit_;
  results::SolidMesh mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> place_of_;
};

}  // namespace diefill::process
