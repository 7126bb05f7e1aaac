// A result compared with measured profiles and maps: statistics zone by zone, and pictures.
#pragma once

#include <string>
#include <vector>

#include "process/results/studies/measured_comparison.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// A picture with what its file is called besides the measured file: "" or such as "_difference".
struct MeasuredPicture {
  std::string suffix;
  Figure figure;
};

/// Of a profile both curves and their difference; of a map both maps, their difference, and simulated over
/// measured values. Maps whose points are no grid have the last one alone. start_offscreen() must have been
/// called.
std::vector<MeasuredPicture> measured_pictures(const results::MeasuredComparison& comparison);

/// All of them as a section of a report.
Section measured_section(const std::vector<results::MeasuredComparison>& comparisons, int level);

/// The statistics as lines of text for a terminal.
std::string measured_text(const results::MeasuredComparison& comparison);

}  // namespace diefill::render::report
