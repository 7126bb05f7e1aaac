#include "process/calibration/starting_powder.h"

#include <toml++/toml.h>

#include <array>

#include "process/scene/powder/powder_file.h"
#include "process/scene/scene_text.h"

namespace diefill::process::calibration {
namespace {

constexpr std::array<const char*, 3> kTables = {"powder", "contact", "walls"};

/// A document with its powder file, if it names one, laid under it.
toml::table document_of(const std::string& text, const std::filesystem::path& file) {
  toml::table document = parse_scene_text(text, file);
  merge_powder_file(document, file);
  return document;
}

}  // namespace

std::string with_starting_powder(const std::filesystem::path& scene, const std::filesystem::path& powder) {
  return with_starting_powder(load_scene_text(scene), scene, powder);
}

std::string with_starting_powder(const std::string& text, const std::filesystem::path& file,
                                 const std::filesystem::path& powder) {
  toml::table document = document_of(text, file);
  std::error_code missing;
  if (powder.empty() || std::filesystem::equivalent(powder, file, missing)) {
    if (toml::table* own = document["powder"].as_table()) own->erase("fitted_with");  // it is fitted again
    return scene_text_of(document);
  }
  toml::table start = document_of(load_scene_text(powder), powder);
  make_spheres_file_absolute(start, powder);
  if (!start.contains("powder"))  // a table, or document_of() would have refused it
    throw SceneError(powder.string() + ": found no [powder], expected a scene or a powder file");
  toml::table own = document["powder"].is_table() ? *document["powder"].as_table() : toml::table{};
  for (const char* key : kTables) {
    document.erase(key);
    if (toml::table* table = start[key].as_table()) document.insert(key, *table);
  }
  toml::table& of_document = *document["powder"].as_table();
  of_document.erase("fitted_with");
  if (toml::node* diameter = own.get("grain_diameter"))
    diameter->visit([&](auto& value) { of_document.insert_or_assign("grain_diameter", std::move(value)); });
  return scene_text_of(document);
}

std::string powder_file_text(const Scene& scene, const std::string& comment, const std::string& account,
                             const std::string& program_version) {
  const toml::table document = parse_scene_text(scene.text, scene.file);
  toml::table kept;
  for (const char* key : kTables)
    if (const toml::table* table = document[key].as_table()) kept.insert(key, *table);
  kept["powder"].as_table()->erase("fitted_with");
  make_spheres_file_absolute(kept, scene.file);
  return comment + scene_text_of(kept) + '\n' + fitted_with_text(fitted_with_of(scene, program_version)) +
         '\n' + account;
}

}  // namespace diefill::process::calibration
