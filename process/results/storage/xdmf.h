// The XDMF text that lets ParaView open results.h5: powder, tools and solid share over time.
#pragma once

#include <string>

#include "process/results/fill_result.h"
#include "process/results/storage/shown_instants.h"

namespace diefill::results {

/// XDMF 2 text about the datasets of `result` in the file `hdf5_name` beside it: all `instants`, and the
/// powder's spheres at the end.
std::string xdmf_text(const FillResult& result, const std::vector<ShownInstant>& instants,
                      const ShownGrid& grid, const std::string& hdf5_name);

}  // namespace diefill::results
