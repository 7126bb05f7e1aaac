// Warnings of a finished run that must not be missed: lost powder, an unfilled cavity, too few grains.
#pragma once

#include <string>
#include <vector>

#include "process/results/fill_result.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Lines for the result's warnings; those that begin with kAlert (setup_findings.h) are likely mistakes. The
/// result holds its figures already.
std::vector<std::string> outcome_text(const Scene& scene, const results::FillResult& result);

/// Of `warnings` those that begin with kAlert, without it.
std::vector<std::string> alerts_of(const std::vector<std::string>& warnings);

}  // namespace diefill::process
