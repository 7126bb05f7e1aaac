#include <toml++/toml.h>

#include <sstream>

#include "process/input/nearest_key.h"
#include "process/scene/scene_text.h"
#include "process/scene/setting.h"

namespace diefill::process {
namespace {

const Choices<Setting>& settings() {
  static const Choices<Setting> choices = {
      {"quick", Setting::quick}, {"working", Setting::working}, {"reference", Setting::reference}};
  return choices;
}

/// Quantities that a setting chooses: table and key.
constexpr std::pair<const char*, const char*> kChosen[] = {{"powder", "grain_diameter"},
                                                           {"numerics", "time_step"},
                                                           {"numerics", "time_step_fraction"},
                                                           {"walls", "spacing"},
                                                           {"pour", "fill_height"}};

constexpr const char* kChosenBy = "# Numbers chosen by: ";
constexpr const char* kChosenLine = "#   ";

}  // namespace

std::string description(Setting setting) {
  for (const auto& [word, value] : settings())
    if (value == setting) return word;
  return {};
}

std::vector<std::string> setting_names() {
  std::vector<std::string> names;
  for (const auto& choice : settings()) names.push_back(choice.first);
  return names;
}

Setting setting_named(const std::string& name) {
  for (const auto& [word, value] : settings())
    if (word == name) return value;
  const auto meant = nearest_key(name, setting_names());
  throw SceneError("--setting: found \"" + name + "\", allowed: quick, working, reference" +
                   (meant ? "; did you mean \"" + *meant + "\"?" : ""));
}

std::optional<Setting> read_setting(TableReader& document) {
  const auto setting = document.choice("setting", settings());
  if (!setting) return std::nullopt;
  for (const auto& [table, key] : kChosen) {
    auto reader = document.table(table);
    if (reader && reader->has(key))
      reader->reject(key, "the setting \"" + description(*setting) + "\" sets it (" +
                              document.where("setting") + "); remove one of the two");
  }
  return setting;
}

std::optional<Setting> setting_of(const Scene& scene) {
  const toml::table document = parse_scene_text(scene.text, scene.file);
  return TableReader(document, scene.file, "").choice("setting", settings());
}

std::string as_comment(const std::vector<std::string>& chosen) {
  std::string text;
  for (const auto& line : chosen) text += (text.empty() ? kChosenBy : kChosenLine) + line + '\n';
  return text;
}

std::vector<std::string> chosen_numbers_in(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::string> chosen;
  for (std::string line; std::getline(lines, line);) {
    const std::string start = chosen.empty() ? kChosenBy : kChosenLine;
    if (!line.starts_with(start)) break;
    chosen.push_back(line.substr(start.size()));
  }
  return chosen;
}

}  // namespace diefill::process
