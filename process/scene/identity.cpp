#include "process/scene/identity.h"

#include <toml++/toml.h>

#include <algorithm>
#include <stdexcept>

#include "engine/numerics/fnv1a.h"
#include "process/results/storage/file_contents.h"
#include "process/results/storage/hash_text.h"
#include "process/scene/scene_text.h"

namespace diefill::process {
namespace {

/// Bytes of a file; nothing where it cannot be read, which those who need it complain about.
std::string bytes_of(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  return results::contents_or_nothing(file).value_or("");
}

}  // namespace

toml::table relevant_document(const std::string& text, const std::filesystem::path& file) {
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
  const toml::table document = relevant_document(text, file);
  engine::Fnv1a hash;
  hash.add(scene_text_of(document));
  for (const std::string& tool : tool_hashes) hash.add(tool);
  for (const std::string& name : input_names(document)) hash.add(bytes_of(file.parent_path() / name));
  return hash.value();
}

std::vector<std::string> input_names(const toml::table& document) {
  std::vector<std::string> names;
  const auto take = [&](toml::node_view<const toml::node> node, const char* key, const char* behind) {
    if (const auto name = node[key].value<std::string>()) names.push_back(*name + behind);
  };
  take(document["powder"], "spheres_file", "");
  if (const toml::array* others = document["other_powder"].as_array())
    for (const toml::node& other : *others)
      take(toml::node_view<const toml::node>(other), "spheres_file", "");
  take(document["pour"], "grains_file", "");
  take(document["pour"], "state", "/results.h5");
  if (const toml::array* steps = document["step"].as_array())
    for (const toml::node& step : *steps) take(toml::node_view<const toml::node>(step), "file", "");
  return names;
}

std::vector<InputFile> input_files(const std::string& text, const std::filesystem::path& file) {
  std::vector<InputFile> files;
  for (const std::string& name : input_names(relevant_document(text, file))) {
    engine::Fnv1a hash;
    hash.add(bytes_of(file.parent_path() / name));
    files.push_back({name, results::hash_text(hash.value())});
  }
  return files;
}

const std::string& hash_of_input(const std::vector<InputFile>& files, const std::string& name) {
  const auto found = std::ranges::find(files, name, &InputFile::name);
  if (found == files.end()) throw std::logic_error("no hash of the input file " + name);
  return found->hash;
}

}  // namespace diefill::process
