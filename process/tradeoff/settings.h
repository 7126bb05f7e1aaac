// The settings of a scene that are tried: the scene as it stands, and one parameter changed at a time.
#pragma once

#include <string>
#include <vector>

#include "process/results/studies/tradeoff.h"
#include "process/tradeoff/parameter.h"

namespace diefill::process {

/// A parameter and the values it is to take.
struct ParameterValues {
  Parameter parameter;
  std::vector<std::string> values;
};

/// What one --vary says, "PARAMETER=V1,V2,..."; commas within quotes, brackets and braces separate nothing.
/// Throws SceneError where it cannot be read or there is no such parameter.
ParameterValues read_vary(const std::string& text);

/// All registered parameters that do something in the scene, with the values worth trying.
std::vector<ParameterValues> usual_parameters(const Scene& scene);

/// One setting: the scene with some parameters changed.
struct TriedSetting {
  std::string name, label;                        ///< as in results::TradeoffPoint
  std::vector<results::ParameterChange> changes;  ///< none for the base
  int finer = 0;        ///< 1: every parameter turned to finer; -1: one to coarser; 0: neither, or unknown
  Variant variant;      ///< as a job of diefill compare
  double work = 0;      ///< work_per_second
  std::string refused;  ///< why the scene cannot be run with it; empty: it can
};

inline constexpr const char* kBase = "base";          ///< name of the scene as it stands
inline constexpr const char* kCombined = "combined";  ///< name of all worthwhile parameters turned together

/// `scene` with these parameters turned from where it stands.
TriedSetting setting_with(const Scene& scene, const std::string& name, const std::string& label,
                          const std::vector<std::pair<Parameter, std::string>>& turned);

/// The scene's [[variant]] tables as settings: parameters turned together. Throws SceneError as read_variants
/// does, and for a scene without variants.
std::vector<TriedSetting> settings_of_variants(const Scene& scene);

/// Gives every setting a folder of its own among these and that of kCombined (scene/folder_names.h).
void assign_folders(std::vector<TriedSetting>& settings);

/// The base, and every parameter at every value that is not the scene's own. A value that the scene refuses
/// is an error with `strict` (SceneError, naming parameter and value) and else a setting that says why.
/// Throws SceneError for two settings of one name. Folders are left to assign_folders.
std::vector<TriedSetting> one_at_a_time(const Scene& scene, const std::vector<ParameterValues>& parameters,
                                        bool strict);

}  // namespace diefill::process
