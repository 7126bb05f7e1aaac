// The XDMF text that lets ParaView open results.h5: powder spheres as points, tools as triangles.
#pragma once

#include <string>

#include "process/results/fill_result.h"

namespace diefill::results {

/// XDMF 2 text about the datasets of `result` in the file `hdf5_name` beside it.
std::string xdmf_text(const FillResult& result, const std::string& hdf5_name);

}  // namespace diefill::results
