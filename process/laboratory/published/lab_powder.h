// The powder of an experiment's run: a preset enlarged with the size of the experiment, or the user's own.
#pragma once

#include <string>

#include "process/laboratory/published/scene_experiment.h"

namespace diefill::process::laboratory {

struct LabPowder {
  double own_size = 0;       ///< m, d that its parameters belong to
  double size = 0;           ///< m, d of the model grains
  double solid_density = 0;  ///< kg/m^3 of the metal; 0: that of the model grains
  SceneChanges changes;      ///< that put it into a scene
};

/// `preset` with grains `scale` times as large as its own; where the setting names a powder, that one in its
/// place, enlarged likewise. Throws SceneError for a wrong powder file.
LabPowder lab_powder(const LabSetting& setting, const std::string& preset, double scale);

/// Whether the setting has a powder of its own, so that an experiment over several presets has one.
bool has_own_powder(const LabSetting& setting);

/// Whether a plan for such a setting has runs of scenes and all of them take that powder.
bool takes_own_powder(const LabPlan& plan);

/// Throws SceneError, in one line with the experiments that take any powder, where the setting names a powder
/// and the experiment's runs would not use it.
void require_use_of_powder(const SceneExperiment& experiment, const LabSetting& setting);

/// "1.88 mm" in quotes, as scenes have lengths; a point of three lengths.
std::string millimetres(double metres);
std::string point_in_millimetres(double x, double y, double z);
/// "0.2 N" in quotes.
std::string with_unit(double value, const char* unit);
/// key = value and a line end.
std::string line(const std::string& key, const std::string& value);
/// A number as TOML.
std::string plain(double value);

}  // namespace diefill::process::laboratory
