// A result as it stood at an earlier instant.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::process {

/// Powder, tools and solid fractions at the kept instant (FillResult::instants) nearest to `time` (s), or the
/// end where that is nearer. Solid fractions are measured again, or left out; maps, sections and profiles are
/// left out. Throws std::invalid_argument, naming what there is, where `time` is farther from all of them and
/// the end than the first two instants are apart, or than 2 % of the end's time where there are fewer.
results::FillResult result_at(const results::FillResult& result, double time,
                              bool with_solid_fraction = true);

/// Powder, tools and cavity at a kept instant, with solid fractions measured again where wanted; nothing else
/// of the result.
results::FillResult powder_at(const results::FillResult& result, const results::Instant& instant,
                              bool with_solid_fraction = true);

/// The tool moved as at instant `instant`; `number` is its place in FillResult::tools.
results::ToolState tool_at(const results::ToolState& tool, const results::Instant& instant,
                           std::size_t number);

}  // namespace diefill::process
