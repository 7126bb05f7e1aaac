// Slips that show in the sizes and places of tools: a wrong unit of length, a part that stands in another.
#pragma once

#include <string>

#include "process/run/tooling.h"

namespace diefill::process {

/// Throws SceneError (beginning with `where`) when the part is larger than any press or too small to be
/// covered with wall spheres of that radius (m): its CAD file is in another unit of length.
void check_size(const geometry::Mesh& mesh, double sphere_radius, const std::string& where);

/// Throws SceneError (beginning with `where`, which is of `tool`) when a corner of one of the two parts lies
/// deeper inside the other than a wall sphere's radius, as they stand at the start. Fits and facets overlap
/// by less.
void check_fit(const Tool& tool, const Tool& other, double sphere_radius, const std::string& where);

}  // namespace diefill::process
