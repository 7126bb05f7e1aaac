// Whether the arrays of a result belong together.
#pragma once

#include "process/results/fill_result.h"

namespace diefill::results {

/// Throws ResultError with one line where arrays that run over the same things differ in length. Arrays over
/// grains may be empty (not measured) as long as the positions are not.
void check_lengths(const FillResult& result);

}  // namespace diefill::results
