// Which parts of a CAD file a name selects.
#pragma once

#include <string>
#include <vector>

#include "geometry/cad/cad_parts.h"

namespace diefill::geometry {

/// Indices into `parts` of what `name` selects; all of them where it is empty. A part's name comes first,
/// then an assembly's, whose parts are taken together, then the first words of one part's name. Throws
/// MeshError, beginning with `file`, where a name fits several parts, with their places in mm of the scene;
/// `metres_per_unit` is that of the file. UnknownPart where it fits none.
std::vector<std::size_t> wanted_parts(const std::vector<CadPart>& parts, const std::string& name,
                                      const std::string& file, double metres_per_unit);

}  // namespace diefill::geometry
