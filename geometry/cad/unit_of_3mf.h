// The unit of length that a 3MF file states, read from its XML: lib3mf takes words that it does not know for
// millimetres.
#pragma once

#include <string>

namespace diefill::geometry {

/// Throws std::runtime_error, naming the units of the standard, where a model in the archive of these bytes
/// states another. Parts of the archive that cannot be read are left to lib3mf.
void refuse_unknown_unit_of_3mf(const std::string& bytes);

}  // namespace diefill::geometry
