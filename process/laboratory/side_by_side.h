// Pieces of an experiment that need nothing of each other, several at a time: small beds leave threads of
// their own too little to share.
#pragma once

#include <functional>
#include <string>

#include "process/laboratory/experiment.h"

namespace diefill::process::laboratory {

/// Told the share of a piece that is done, 0 to 1.
using TellShare = std::function<void(double share)>;

/// Calls work(piece, tell) for every piece below `pieces`, on as many threads as the options say, and tells
/// their user how far all of them are. `doing` says what they are. Throws what work throws.
void side_by_side(const ExperimentOptions& options, std::size_t pieces, const std::string& doing,
                  const std::function<void(std::size_t piece, const TellShare& tell)>& work);

}  // namespace diefill::process::laboratory
