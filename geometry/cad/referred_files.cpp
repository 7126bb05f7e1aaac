#include "geometry/cad/referred_files.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "geometry/cad/cad_file.h"
#include "geometry/cad/cad_parts.h"
#include "geometry/cad/gltf_document.h"
#include "geometry/cad/percent_decoding.h"

namespace diefill::geometry {
namespace {

namespace fs = std::filesystem;

/// Names in a glTF document; data that stands in the document itself is no file.
std::vector<std::string> names_in_gltf(const std::string& text) {
  std::vector<std::string> names;
  const auto document = nlohmann::json::parse(text, nullptr, false);
  if (!document.is_object()) return names;
  for (const char* list : {"buffers", "images"}) {
    const auto entries = document.find(list);
    if (entries == document.end() || !entries->is_array()) continue;
    for (const auto& entry : *entries) {
      if (!entry.is_object() || !entry.contains("uri") || !entry["uri"].is_string()) continue;
      const auto name = entry["uri"].get<std::string>();
      if (name.starts_with("data:")) continue;
      names.push_back(name);
      names.push_back(percent_decoded(name));
    }
  }
  return names;
}

/// Names after `mtllib`: one that may hold blanks, or several between blanks.
std::vector<std::string> names_in_obj(const std::string& text) {
  std::vector<std::string> names;
  const std::string keyword = "mtllib";
  for (std::size_t at = text.find(keyword); at != std::string::npos; at = text.find(keyword, at + 1)) {
    if (at > 0 && text[at - 1] != '\n' && text[at - 1] != '\r') continue;
    const std::size_t start = at + keyword.size(), end = text.find_first_of("\r\n", start);
    const std::string rest = text.substr(start, end == std::string::npos ? end : end - start);
    const std::size_t first = rest.find_first_not_of(" \t");
    if (first == 0 || first == std::string::npos) continue;
    names.push_back(rest.substr(first, rest.find_last_not_of(" \t") - first + 1));
    std::istringstream words(rest);
    for (std::string word; words >> word;) names.push_back(word);
  }
  return names;
}

std::vector<std::string> names_in(const fs::path& file, const std::string& ending) {
  if (ending == "gltf" || ending == "glb") return names_in_gltf(json_of_gltf(read_cad_file(file)));
  if (ending == "obj") return names_in_obj(read_cad_file(file));
  return {};
}

/// Whether it stays in the folder that it is relative to.
bool stays_inside(const fs::path& name) {
  return !name.empty() && name.is_relative() && *name.begin() != ".." && name != ".";
}

}  // namespace

std::vector<fs::path> referred_files(const fs::path& file) {
  std::vector<fs::path> files;
  const CadFormat* format = cad_format(file);
  if (format == nullptr) return files;
  for (const std::string& name : names_in(file, format->ending)) {
    if (name.find('\0') != std::string::npos) continue;
    const fs::path relative = fs::path(name).lexically_normal();
    std::error_code error;
    const fs::path place = file.parent_path() / relative;
    if (!stays_inside(relative) || relative == file.filename()) continue;
    // Empty ones hold nothing that could count.
    if (!fs::is_regular_file(place, error) || fs::file_size(place, error) == 0 || error) continue;
    if (std::find(files.begin(), files.end(), relative) == files.end()) files.push_back(relative);
  }
  return files;
}

}  // namespace diefill::geometry
