#include "process/scene/identity.h"

#include <toml++/toml.h>

#include "engine/numerics/fnv1a.h"
#include "process/results/storage/file_contents.h"
#include "process/scene/scene_text.h"

namespace diefill::process {
namespace {

/// Bytes of a file; nothing where it cannot be read, which those who need it complain about.
std::string bytes_of(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  return results::contents_or_nothing(file).value_or("");
}

/// Of the files of clumps' spheres, of placed grains, of the state that powder begins with, and of the tables
/// that steps follow, in the order of the steps.
void add_referred_files(engine::Fnv1a& hash, const toml::table& document, const std::filesystem::path& file) {
  if (const auto spheres = document["powder"]["spheres_file"].value<std::string>())
    hash.add(bytes_of(file.parent_path() / *spheres));
  if (const toml::array* others = document["other_powder"].as_array())
    for (const toml::node& other : *others)
      if (const auto spheres = toml::node_view(other)["spheres_file"].value<std::string>())
        hash.add(bytes_of(file.parent_path() / *spheres));
  if (const auto grains = document["pour"]["grains_file"].value<std::string>())
    hash.add(bytes_of(file.parent_path() / *grains));
  if (const auto state = document["pour"]["state"].value<std::string>())
    hash.add(bytes_of(file.parent_path() / *state / "results.h5"));
  const toml::array* steps = document["step"].as_array();
  if (steps == nullptr) return;
  for (const toml::node& step : *steps) {
    const toml::table* table = step.as_table();
    const auto name = table == nullptr ? std::nullopt : (*table)["file"].value<std::string>();
    if (name) hash.add(bytes_of(file.parent_path() / *name));
  }
}

}  // namespace

toml::table acting_document(const std::string& text, const std::filesystem::path& file) {
  toml::table document = parse_scene_text(text, file);
  document.erase("title");
  document.erase("variant");
  if (toml::table* numerics = document["numerics"].as_table()) {
    numerics->erase("max_time");
    numerics->erase("checkpoint_interval");
    if (numerics->empty()) document.erase("numerics");
  }
  return document;
}

std::uint64_t scene_identity(const std::string& text, const std::filesystem::path& file,
                             const std::vector<std::string>& tool_hashes) {
  const toml::table document = acting_document(text, file);
  engine::Fnv1a hash;
  hash.add(scene_text_of(document));
  for (const std::string& tool : tool_hashes) hash.add(tool);
  add_referred_files(hash, document, file);
  return hash.value();
}

}  // namespace diefill::process
