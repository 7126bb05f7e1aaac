// The section of a report on what was recorded while the scene ran.
#pragma once

#include <string>
#include <vector>

#include "process/results/fill_result.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// Charts over time: the solid fraction of all zones in one, and one of every probe. Without blocks where
/// nothing was recorded.
Section over_time_section(const results::FillResult& result);

/// The words with which all names begin, or else end: "force" of "force x" and "force y", "level" of "mean
/// level" and "lowest level"; "value" where there are none.
std::string common_words(const std::vector<std::string>& names);

}  // namespace diefill::render::report
