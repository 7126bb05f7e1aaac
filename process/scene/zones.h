// Zones of a part as a scene names them: [[measure.zone]].
#pragma once

#include <string>
#include <vector>

#include "process/input/table_reader.h"
#include "process/measure/figures/zone.h"

namespace diefill::process {

/// All [[zone]] tables of [measure]. Throws SceneError.
std::vector<Zone> read_zones(TableReader& measure);

/// The zones in the text of a scene that has been read before, such as that of results.
std::vector<Zone> zones_in(const std::string& scene_text);

}  // namespace diefill::process
