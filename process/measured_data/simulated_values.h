// Values of a result's profiles, maps and sections at the places of measurements.
#pragma once

#include <string>
#include <vector>

#include "process/measured_data/measured_table.h"
#include "process/results/fill_result.h"

namespace diefill::process {

/// The profile called `quantity` ("fill level", or "fill level over azimuth") that runs over the table's
/// places, there, in the unit of its values; NaN where it has none. Azimuths continue round the circle
/// (value_at). `where` begins messages. Throws SceneError where the result has no such profile, with those it
/// has, and for places of another name and units of another dimension.
std::vector<double> profile_values(const results::FillResult& result, const std::string& quantity,
                                   const MeasuredTable& data, const std::string& where);

/// The same of a map, by its quantity, or of a section, by the name of its plane; the order of the places
/// does not count.
std::vector<double> map_values(const results::FillResult& result, const std::string& quantity,
                               const MeasuredTable& data, const std::string& where);

}  // namespace diefill::process
