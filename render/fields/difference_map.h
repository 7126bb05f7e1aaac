// What changed between two times, passages or runs: differences about zero.
#pragma once

#include "render/fields/density_map.h"

namespace diefill::render {

/// `change` (after minus before) in colours that run from blue (less) over white (the same) to red (more),
/// the same distance to both sides. `compared` says what minus what. `limit` NaN: from the data.
FieldPicture compose_difference(const results::Field2D& change, const std::string& title,
                                const std::string& compared, double limit, FieldStyle style);

}  // namespace diefill::render
