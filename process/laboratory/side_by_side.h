// Runs independent pieces of an experiment in parallel: a small bed has too little work for several threads.
#pragma once

#include <functional>
#include <string>

#include "process/laboratory/experiment.h"

namespace diefill::process::laboratory {

/// Receives the finished share of a piece, 0 to 1.
using ShareCallback = std::function<void(double share)>;

/// Calls work(piece, on_progress) for every piece below `pieces`, on as many threads as the options say, and
/// reports the progress of all to options.on_progress. `doing` names the pieces. Throws what work throws.
void side_by_side(const ExperimentOptions& options, std::size_t pieces, const std::string& doing,
                  const std::function<void(std::size_t piece, const ShareCallback& on_progress)>& work);

}  // namespace diefill::process::laboratory
