// Which tool has the wrong scale, as when its file is read in another unit of length.
#pragma once

#include <string>
#include <vector>

#include "process/tooling/tooling.h"

namespace diefill::process {

/// Factors by which units of length are mistaken for each other: cm for mm, inch for mm, m for mm, um for mm
/// and the reverse.
std::vector<double> unit_factors();

/// The mesh as it would be were its file's unit `factor` times as long.
geometry::Mesh rescaled(const Tool& tool, double factor);

/// What to do about a tool that should be `factor` times as large: names the unit where one is known, for
/// length_unit or, where the file states its unit itself, for the export.
std::string unit_advice(const Tool& tool, double factor);

}  // namespace diefill::process
