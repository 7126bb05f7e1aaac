// A result as it stood at an earlier instant.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::process {

/// Powder, tools and solid fractions at the kept instant (FillResult::instants) nearest to `time` (s), or the
/// end where that is nearer. Solid fractions are measured again, or left out; maps, sections and profiles are
/// left out. Throws std::invalid_argument, naming what there is, where `time` is farther from all of them and
/// the end than the first two instants are apart, or than 2 % of the end's time where there are fewer. All
/// positions are in the frame of the die as it was then, as those of the end are in its frame at the end.
results::FillResult result_at(const results::FillResult& result, double time,
                              bool with_solid_fraction = true);
/// The same with powder and tools in the frame of FillResult::instants, so that films show how a die is
/// shaken.
results::FillResult film_frame_at(const results::FillResult& result, double time,
                                  bool with_solid_fraction = true);

/// Powder, tools and cavities at a kept instant, with solid fractions measured again where wanted; nothing
/// else of the result. All in the frame of the die at that instant.
results::FillResult powder_at(const results::FillResult& result, const results::Instant& instant,
                              bool with_solid_fraction = true);

/// The tool moved as at instant `instant`, in the frame of FillResult::instants; `number` is its place in
/// FillResult::tools.
results::ToolState tool_at(const results::ToolState& tool, const results::Instant& instant,
                           std::size_t number);

}  // namespace diefill::process
