// `diefill map --measured`: a result beside measured profiles and maps.
#pragma once

#include <vector>

#include "app/pictures/picture_kinds.h"
#include "process/measured_data/compare_with_measured.h"

namespace diefill::app {

/// Writes pictures and tables that compare the first source with each file, prints the statistics; the exit
/// code. Throws process::SceneError, before anything is written, where that would replace a file of the
/// user's.
int draw_against_measured(const PictureRequest& request, const std::vector<process::MeasuredFile>& measured);

}  // namespace diefill::app
