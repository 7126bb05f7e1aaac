#include "process/tradeoff/settings.h"

#include <algorithm>
#include <regex>

#include "process/results/trimmed.h"
#include "process/scene/folder_names.h"
#include "process/tradeoff/parameter_registry.h"
#include "process/tradeoff/work_estimate.h"

namespace diefill::process {
namespace {

/// Parts of `text` between commas that stand in no quotes, brackets or braces.
std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  for (const char letter : text) {
    if (letter == '"') quoted = !quoted;
    if (!quoted && (letter == '[' || letter == '{')) ++depth;
    if (!quoted && (letter == ']' || letter == '}')) --depth;
    if (letter == ',' && depth == 0 && !quoted)
      parts.emplace_back();
    else
      parts.back() += letter;
  }
  for (std::string& part : parts) part = std::string(results::trimmed(part));
  return parts;
}

/// Of a message about a change, which stands in no file: without file, line and column.
std::string without_place(const std::string& message) {
  static const std::regex place(R"(^(--vary, change [0-9]+|.*?:[0-9]+(:[0-9]+)?): )");
  return std::regex_replace(message, place, "", std::regex_constants::format_first_only);
}

int finer_than_base(const Scene& scene, const std::vector<std::pair<Parameter, std::string>>& turned) {
  bool all_finer = !turned.empty();
  for (const auto& [parameter, value] : turned) {
    const int order = fineness(parameter, value, parameter.current(scene));
    if (order < 0) return -1;
    all_finer = all_finer && order > 0;
  }
  return all_finer ? 1 : 0;
}

SceneChanges changes_of(const Scene& scene, const std::vector<std::pair<Parameter, std::string>>& turned) {
  SceneChanges all;
  all.source = "--vary";
  for (const auto& [parameter, value] : turned) {
    const SceneChanges changes = parameter.changes(scene, value);
    all.set += changes.set;
    all.without.insert(all.without.end(), changes.without.begin(), changes.without.end());
  }
  return all;
}

}  // namespace

ParameterValues read_vary(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || results::trimmed(text.substr(0, equals)).empty())
    throw SceneError(
        "--vary: found \"" + text +
        "\", expected PARAMETER=VALUE,VALUE,..., such as --vary \"grain_diameter=0.94 mm,1.88 mm\"");
  ParameterValues varied{parameter_called(std::string(results::trimmed(text.substr(0, equals)))),
                         split_at_commas(text.substr(equals + 1))};
  for (const std::string& value : varied.values)
    if (value.empty())
      throw SceneError("--vary: found \"" + text + "\", a value is empty; separate values with commas");
  return varied;
}

std::vector<ParameterValues> usual_parameters(const Scene& scene) {
  std::vector<ParameterValues> all;
  for (const Parameter& parameter : parameter_registry())
    if (auto values = parameter.usual(scene); !values.empty()) all.push_back({parameter, std::move(values)});
  return all;
}

TriedSetting setting_with(const Scene& scene, const std::string& name, const std::string& label,
                          const std::vector<std::pair<Parameter, std::string>>& turned) {
  TriedSetting setting;
  setting.name = name;
  setting.label = label;
  for (const auto& [parameter, value] : turned) setting.changes.push_back({parameter.name, value});
  setting.finer = finer_than_base(scene, turned);
  setting.variant.name = name;
  setting.variant.folder = folder_of_name(name);
  try {
    setting.variant.scene = changed_scene(scene.text, scene.file, changes_of(scene, turned));
    setting.work = work_per_second(setting.variant.scene);
  } catch (const SceneError& error) {
    setting.refused = without_place(error.what());
  }
  return setting;
}

std::vector<TriedSetting> settings_of_variants(const Scene& scene) {
  if (!has_variants(scene))
    throw SceneError(scene.file.string() +
                     ": --variants: the scene has no variants; add [[variant]] tables or remove the option");
  std::vector<TriedSetting> settings;
  for (Variant& variant : read_variants(scene.file)) {
    TriedSetting setting;
    setting.name = setting.label = variant.name;
    setting.changes = {{"variant", variant.name}};
    setting.work = work_per_second(variant.scene);
    setting.variant = std::move(variant);
    settings.push_back(std::move(setting));
  }
  return settings;
}

void assign_folders(std::vector<TriedSetting>& settings) {
  std::vector<std::string> names = {kCombined};
  for (const TriedSetting& setting : settings) names.push_back(setting.name);
  const auto folders = folder_names(names);
  for (std::size_t k = 0; k < settings.size(); ++k) settings[k].variant.folder = folders[k + 1];
}

std::vector<TriedSetting> one_at_a_time(const Scene& scene, const std::vector<ParameterValues>& parameters,
                                        bool strict) {
  std::vector<TriedSetting> settings = {setting_with(scene, kBase, kBase, {})};
  if (!settings.front().refused.empty())
    throw SceneError(scene.file.string() + ": " + settings.front().refused);
  for (const auto& [parameter, values] : parameters) {
    const std::string now = parameter.current(scene);
    for (const std::string& value : values) {
      if (same_value(parameter, value, now)) continue;
      const std::string name = parameter.name + '=' + value;
      TriedSetting setting = setting_with(scene, name, parameter.sign + ' ' + value, {{parameter, value}});
      if (strict && !setting.refused.empty()) throw SceneError("--vary " + name + ": " + setting.refused);
      const auto same = [&](const TriedSetting& other) { return other.name == setting.name; };
      if (std::any_of(settings.begin(), settings.end(), same))
        throw SceneError("--vary " + name + ": this setting is given twice; give each value once");
      settings.push_back(std::move(setting));
    }
  }
  return settings;
}

}  // namespace diefill::process
