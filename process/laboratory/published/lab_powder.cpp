#include "process/laboratory/published/lab_powder.h"

#include <cstdio>

#include "process/scene/powder_presets.h"
#include "process/scene/scene_text.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kAnyScene = "bed.toml";  // that reads the powder file

}  // namespace

bool has_own_powder(const LabSetting& setting) {
  return !setting.powder.empty();
}

LabPowder lab_powder(const LabSetting& setting, const std::string& preset, double scale) {
  LabPowder powder;
  if (!has_own_powder(setting)) {
    powder.own_size = nominal_grain_diameter(powder_preset(preset).model);
    powder.solid_density = preset_solid_density(powder_preset(preset));
    powder.changes.set = line("powder.preset", '"' + preset + '"');
  } else {
    const std::filesystem::path scene = setting.scenes / kAnyScene;
    SceneChanges only;
    only.without = {"powder"};
    only.set = line("powder.file", '"' + std::filesystem::absolute(setting.powder).string() + '"');
    const Scene read = changed_scene(load_scene_text(scene), scene, only);
    powder.own_size = read.powder.grain_diameter / coarse_graining_factor(read.powder);
    powder.solid_density = preset_solid_density(read.powder);
    powder.changes = only;
  }
  powder.size = scale * powder.own_size;
  powder.changes.set += line("powder.grain_diameter", millimetres(powder.size));
  return powder;
}

std::string plain(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

std::string millimetres(double metres) {
  return '"' + plain(1e3 * metres) + " mm\"";
}

std::string point_in_millimetres(double x, double y, double z) {
  return '[' + millimetres(x) + ", " + millimetres(y) + ", " + millimetres(z) + ']';
}

std::string line(const std::string& key, const std::string& value) {
  return key + " = " + value + '\n';
}

}  // namespace diefill::process::laboratory
