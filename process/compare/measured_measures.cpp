#include "process/compare/measured_measures.h"

#include <algorithm>
#include <string_view>

#include "process/compare/job_folder.h"
#include "process/input/scene_error.h"
#include "process/results/none.h"
#include "process/scene/scene_text.h"
#include "process/scene/zones.h"

namespace diefill::process {
namespace {

constexpr const char* kAll = "all";

using OfZone = double (*)(const results::MeasuredZone&);

double difference_of(const results::MeasuredZone& zone) {
  return zone.simulated - zone.measured;
}

double rms_of(const results::MeasuredZone& zone) {
  return zone.rms;
}

double correlation_of(const results::MeasuredZone& zone) {
  return zone.correlation;
}

/// NaN where no measured place with a value lies in the zone.
double value_in(const results::MeasuredComparison& comparison, const std::string& zone, OfZone value) {
  const auto found = std::find_if(comparison.zones.begin(), comparison.zones.end(),
                                  [&](const results::MeasuredZone& one) { return one.name == zone; });
  return found == comparison.zones.end() ? kNone : value(*found);
}

/// "_in_flange", as the zone's figures have it.
std::string key_ending(const std::string& zone) {
  return zone_share_figure(zone).substr(std::string_view("mass_share").size());
}

FurtherMeasure measure_of(const MeasuredFile& file, const std::string& key, const std::string& words,
                          const std::string& unit, const std::string& zone, OfZone value) {
  const std::string name = file.file.stem().string();
  const bool in_all = zone == kAll;
  return {{"measured_" + name + '_' + key + (in_all ? "" : key_ending(zone)),
           words + ' ' + name + (in_all ? "" : " in " + zone), unit, 1, 0},
          [file, zone, value](const results::FillResult& result) {
            return value_in(compare_with_measured(file, result), zone, value);
          }};
}

}  // namespace

std::vector<std::string> zones_of_jobs(const std::filesystem::path& directory) {
  std::vector<std::string> names;
  for (const results::Job& job : results::read_job_list(directory).jobs) {
    const std::filesystem::path file = directory / job.folder / kJobScene;
    if (!std::filesystem::exists(file)) continue;
    try {
      for (const Zone& zone : zones_in(load_scene_text(file)))
        if (std::find(names.begin(), names.end(), zone.name) == names.end()) names.push_back(zone.name);
    } catch (const SceneError&) {
      continue;  // a damaged scene: its results have what the others have, or count as a failed run
    }
  }
  return names;
}

std::vector<FurtherMeasure> measures_against(const std::vector<MeasuredFile>& files,
                                             const std::vector<std::string>& zones) {
  std::vector<FurtherMeasure> measures;
  for (const MeasuredFile& file : files) {
    const std::string unit = file.table.value.unit;
    const auto add = [&](const std::string& key, const std::string& words, const std::string& its_unit,
                         const std::string& zone, OfZone value) {
      measures.push_back(measure_of(file, key, words, its_unit, zone, value));
    };
    add("difference", "mean difference from measured", unit, kAll, difference_of);
    add("rms", "rms difference from measured", unit, kAll, rms_of);
    add("correlation", "correlation with measured", "1", kAll, correlation_of);
    for (const std::string& zone : zones) {
      if (zone == kAll) continue;  // what is called so holds all places
      add("difference", "mean difference from measured", unit, zone, difference_of);
      add("correlation", "correlation with measured", "1", zone, correlation_of);
    }
  }
  return measures;
}

}  // namespace diefill::process
