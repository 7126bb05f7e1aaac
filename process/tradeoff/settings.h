// The settings of a scene that are tried: the scene as it stands, and one knob changed at a time.
#pragma once

#include <string>
#include <vector>

#include "process/results/studies/tradeoff.h"
#include "process/tradeoff/knob.h"

namespace diefill::process {

/// A knob and the values it is to take.
struct KnobValues {
  Knob knob;
  std::vector<std::string> values;
};

/// What one --vary says, "KNOB=V1,V2,..."; commas within quotes, brackets and braces separate nothing. Throws
/// SceneError where it cannot be read or there is no such knob.
KnobValues read_vary(const std::string& text);

/// All registered knobs that do something in the scene, with the values worth trying.
std::vector<KnobValues> usual_knobs(const Scene& scene);

/// One setting: the scene with some knobs changed.
struct TriedSetting {
  std::string name, label;                   ///< as in results::TradeoffPoint
  std::vector<results::KnobChange> changes;  ///< none for the base
  int finer = 0;        ///< 1: every knob turned to finer; -1: one to coarser; 0: neither, or unknown
  Variant variant;      ///< as a job of diefill compare
  double work = 0;      ///< work_per_second
  std::string refused;  ///< why the scene cannot be run with it; empty: it can
};

inline constexpr const char* kBase = "base";          ///< name of the scene as it stands
inline constexpr const char* kCombined = "combined";  ///< name of all worthwhile knobs turned together

/// `scene` with these knobs turned from where it stands.
TriedSetting setting_with(const Scene& scene, const std::string& name, const std::string& label,
                          const std::vector<std::pair<Knob, std::string>>& turned);

/// The scene's [[variant]] tables as settings: knobs turned together. Throws SceneError as read_variants
/// does, and for a scene without variants.
std::vector<TriedSetting> settings_of_variants(const Scene& scene);

/// Gives every setting a folder of its own among these and that of kCombined (scene/folder_names.h).
void assign_folders(std::vector<TriedSetting>& settings);

/// The base, and every knob at every value that is not the scene's own. A value that the scene refuses is an
/// error with `strict` (SceneError, naming knob and value) and else a setting that says why. Throws
/// SceneError for two settings of one name. Folders are left to assign_folders.
std::vector<TriedSetting> one_at_a_time(const Scene& scene, const std::vector<KnobValues>& knobs,
                                        bool strict);

}  // namespace diefill::process
