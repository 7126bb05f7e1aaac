#include "process/laboratory/published/lab_powder.h"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "process/input/toml_string.h"
#include "process/results/formatted.h"
#include "process/scene/powder/grain_models.h"
#include "process/scene/powder/powder_file.h"
#include "process/scene/powder/powder_presets.h"
#include "process/scene/scene_text.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kAnyScene = "bed.toml";  // that reads the powder file
constexpr const char* kTables[] = {"powder", "contact", "walls"};

/// A line for each value of a table, tables within it key by key.
std::string lines_of(const toml::table& table, const std::string& path) {
  std::string lines;
  for (const auto& [key, node] : table) {
    const std::string name = path + '.' + toml_string(std::string(key.str()));
    if (const toml::table* inner = node.as_table()) {
      lines += lines_of(*inner, name);
      continue;
    }
    std::ostringstream value;
    node.visit([&](const auto& each) { value << each; });
    lines += line(name, value.str());
  }
  return lines;
}

/// What puts the powder of a file into a scene: of a powder file by its name; of a scene its [powder],
/// [contact] and [walls] in place of all others, but for the grain size, and under what an experiment varies.
SceneChanges powder_changes(const std::filesystem::path& file) {
  toml::table document = parse_scene_text(load_scene_text(file), file);
  SceneChanges changes;
  if (!document.contains("tool")) {
    changes.without = {"powder"};
    changes.set = line("powder.file", toml_string(std::filesystem::absolute(file).string()));
    return changes;
  }
  merge_powder_file(document, file);
  make_spheres_file_absolute(document, file);
  if (toml::table* powder = document["powder"].as_table()) powder->erase("grain_diameter");
  for (const char* name : kTables) {
    changes.without.emplace_back(name);
    if (const toml::table* table = document[name].as_table()) changes.under += lines_of(*table, name);
  }
  return changes;
}

/// The powder of a scene or powder file with its grain size.
PowderSpec powder_in(const std::filesystem::path& file, const std::filesystem::path& any_scene,
                     const SceneChanges& changes) {
  if (parse_scene_text(load_scene_text(file), file).contains("tool")) return read_scene(file).powder;
  return changed_scene(load_scene_text(any_scene), any_scene, changes).powder;
}

}  // namespace

bool has_own_powder(const LabSetting& setting) {
  return !setting.powder.empty();
}

bool takes_own_powder(const LabPlan& plan) {
  const auto takes_it = [](const LabRun& run) {
    const auto& without = run.changes.without;
    return std::find(without.begin(), without.end(), kTables[0]) != without.end();
  };
  return !plan.runs.empty() && std::all_of(plan.runs.begin(), plan.runs.end(), takes_it);
}

void require_use_of_powder(const SceneExperiment& experiment, const LabSetting& setting) {
  if (!has_own_powder(setting) || takes_own_powder(experiment.plan(setting))) return;
  std::string others;
  for (const SceneExperiment& other : scene_experiments())
    if (takes_own_powder(other.plan(setting))) others += (others.empty() ? "" : ", ") + other.name;
  throw SceneError(
      "--powder: found \"" + setting.powder.string() + "\", but " + experiment.name +
      " has powders of its own; leave it out, or choose an experiment that takes any powder: " + others);
}

LabPowder lab_powder(const LabSetting& setting, const std::string& preset, double scale) {
  LabPowder powder;
  if (!has_own_powder(setting)) {
    powder.own_size = facts_of(powder_preset(preset).model).grain_diameter;
    powder.solid_density = preset_solid_density(powder_preset(preset));
    powder.changes.set = line("powder.preset", '"' + preset + '"');
  } else {
    powder.changes = powder_changes(setting.powder);
    const PowderSpec read = powder_in(setting.powder, setting.scenes / kAnyScene, powder.changes);
    powder.own_size = read.grain_diameter / coarse_graining_factor(read);
    powder.solid_density = preset_solid_density(read);
  }
  powder.size = scale * powder.own_size;
  powder.changes.set += line("powder.grain_diameter", millimetres(powder.size));
  return powder;
}

std::string plain(double value) {
  return results::formatted("%.10g", value);
}

std::string with_unit(double value, const char* unit) {
  return '"' + plain(value) + ' ' + unit + '"';
}

std::string millimetres(double metres) {
  return with_unit(1e3 * metres, "mm");
}

std::string point_in_millimetres(double x, double y, double z) {
  return '[' + millimetres(x) + ", " + millimetres(y) + ", " + millimetres(z) + ']';
}

std::string line(const std::string& key, const std::string& value) {
  return key + " = " + value + '\n';
}

}  // namespace diefill::process::laboratory
