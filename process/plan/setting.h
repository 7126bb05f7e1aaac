// What a setting (quick, working, reference) means for a scene: grain size, time step, wall spheres and fill
// height, each with its reason.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/cavity/cavity.h"
#include "process/scene/setting.h"

namespace diefill::process::plan {

/// Coarsest grains over the narrowest cavity width that a density map can be decided from, and that have been
/// run at all (the quick start's 1.88 mm in 4.462 mm).
inline constexpr double kCoarsestToDecide = 1.0 / 3, kCoarsestRun = 0.42;
/// Coarse graining has been compared with published figures up to this factor (Bierwisch 2009, Table 4.4).
inline constexpr double kProvenFactor = 4;
/// m: deeper powder in the shoe changes nothing (Bierwisch 2009, section 4.1.6: 19 and 41 mm agree, 10 mm
/// does not, model D2).
inline constexpr double kEnoughPowder = 0.019;

/// Numbers that take the place of the scene's. SI units.
struct SettingNumbers {
  double grain_diameter = 0;         ///< m
  std::optional<double> time_step;   ///< s; nothing: as the program chooses
  double wall_spacing = 1.6;         ///< over the wall spheres' radius
  double fill_height = 0;            ///< m
  std::vector<std::string> reasons;  ///< a line each
};

/// Why no setting can be chosen for the scene; empty where all can.
std::string why_no_settings(const Scene& scene);

/// m, grain size of the powder before coarse graining.
double calibrated_diameter(const PowderSpec& powder);

/// The setting's numbers for a scene with this cavity.
SettingNumbers numbers_of(Setting setting, const Scene& scene, const geometry::Cavity& cavity);

/// `scene` with these numbers written into its text and read again, so that all checks hold and a result says
/// what was run. `origin` names the source of the choice, such as "setting working". What is replaced is said
/// at the top of the text (process/scene/setting.h). Throws SceneError where the numbers do not suit the
/// scene.
Scene with_numbers(const Scene& scene, const SettingNumbers& numbers, const std::string& origin);

/// The scene as it is to be run: with the numbers of `wanted`, or else of its own setting; unchanged if there
/// is neither. Reads the tools if need be.
Scene scene_with_setting(const Scene& scene, const std::optional<Setting>& wanted);

}  // namespace diefill::process::plan
