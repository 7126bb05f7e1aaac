// Checks sizes and positions of tools: a wrong unit of length, a part that overlaps another.
#pragma once

#include <string>

#include "geometry/solid/penetration.h"
#include "process/tooling/tooling.h"

namespace diefill::process {

/// "file:line: tool "name"", where messages about a tool begin.
std::string tool_text(const Scene& scene, const ToolSpec& spec);

/// Unit of length of a CAD file.
struct FileUnit {
  double metres = 0;    ///< m per unit
  bool stated = false;  ///< by the file itself: a length_unit in the scene that differs is refused
};

/// Radius of the wall spheres of a tool.
struct WallRadius {
  double metres = 0;
  std::string key = "walls.sphere_radius";  ///< that gives it
};

/// Throws SceneError (beginning with `where`) when the part is larger than any press or too small to be
/// covered with wall spheres of that radius, as when its CAD file is in another unit than `unit`, or the
/// radius is too large.
void check_size(const geometry::Mesh& mesh, const WallRadius& radius, const FileUnit& unit,
                const std::string& where);

/// How deep one part reaches into the other: of corners exactly, elsewhere to `resolution` (m) or a two
/// hundredth of the part's size.
geometry::Penetration deepest_overlap(const Tool& one, const Tool& other, double resolution);

/// Throws SceneError (beginning with `where`, which is of `tool`) when one of the two parts lies deeper
/// inside the other than a wall sphere's radius, as they stand at the start. Fits and facets overlap by less,
/// and so may parts none of whose corners lies in the other, by up to twice as much. Throws it also where one
/// is the other, or a body of it, at the same place, which no corner that lies inside shows.
void check_fit(const Tool& tool, const Tool& other, double sphere_radius, const std::string& where);

}  // namespace diefill::process
