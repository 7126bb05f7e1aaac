#include "process/scene/placed_grains.h"

#include <toml++/toml.h>

#include "process/scene/reading/read_sphere_file.h"
#include "process/scene/scene_text.h"

namespace diefill::process {

std::optional<std::filesystem::path> grains_file_of(const Scene& scene) {
  constexpr const char* kKey = "grains_file";
  if (scene.text.find(kKey) == std::string::npos) return std::nullopt;  // most scenes; saves parsing
  const toml::table document = parse_scene_text(scene.text, scene.file);
  const auto name = document["pour"][kKey].value<std::string>();
  if (!name) return std::nullopt;
  return scene.file.parent_path() / *name;
}

std::vector<engine::ClumpSphere> grains_in_file(const std::filesystem::path& file) {
  constexpr std::size_t kLargest = 1 << 28;  // bytes
  try {
    return spheres_in_file(file, kLargest);
  } catch (const SceneError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw SceneError("pour.grains_file: " + std::string(error.what()));
  }
}

}  // namespace diefill::process
