#include "process/scene/placed_grains.h"

#include "process/input/scene_error.h"
#include "process/scene/reading/read_sphere_file.h"

namespace diefill::process {

std::vector<engine::ClumpSphere> grains_in_file(const std::filesystem::path& file) {
  try {
    return spheres_in_file(file, kPlacedGrains).spheres;
  } catch (const SceneError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw SceneError("pour.grains_file: " + std::string(error.what()));
  }
}

}  // namespace diefill::process
