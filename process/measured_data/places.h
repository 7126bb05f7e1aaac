// Places of measured values: which may be given, and the end that closed curves and maps repeat.
#pragma once

#include "process/measured_data/measured_table.h"

namespace diefill::process {

/// Removes the points of a full turn that repeat its beginning: those 360 deg beyond points with the same
/// value, as in maps from 0 to 360 deg. Both would count.
void drop_repeated_end(MeasuredTable& table);

/// Throws SceneError for places given twice (azimuths modulo 360 deg), azimuths outside -360 to 720 deg, and
/// points of a curve out of order.
void check_places(const MeasuredTable& table);

}  // namespace diefill::process
