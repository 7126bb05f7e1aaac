#include "process/press_mesh/mesh_builder.h"

#include <stdexcept>

#include "process/input/scene_error.h"

namespace diefill::process {

void MeshBuilder::add_node(std::uint64_t number, const Eigen::Vector3d& place) {
  const auto next = static_cast<std::uint32_t>(mesh_.nodes.size());
  if (!place_of_.emplace(number, next).second)
    lines_.reject_text("node " + std::to_string(number) + " is defined twice, allowed: each number once");
  mesh_.nodes.push_back(unit_ * place);
  mesh_.node_numbers.push_back(number);
}

void MeshBuilder::add_element(std::uint64_t number, results::ElementShape shape,
                              const std::vector<std::uint64_t>& nodes) {
  results::SolidElement element{shape, number, {}};
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const auto found = place_of_.find(nodes[n]);
    if (found == place_of_.end())
      lines_.reject_text("element " + std::to_string(number) + " has node " + std::to_string(nodes[n]) +
                         ", which is not defined before this line");
    element.nodes[n] = found->second;
  }
  mesh_.elements.push_back(element);
}

results::SolidMesh MeshBuilder::finish(const std::string& file) {
  results::drop_unused_nodes(mesh_);
  try {
    results::check_solid_mesh(mesh_);
  } catch (const std::invalid_argument& reason) {
    throw SceneError(file + ": " + reason.what());
  }
  return std::move(mesh_);
}

}  // namespace diefill::process
