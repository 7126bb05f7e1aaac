// Percent-encoded names, as glTF files have them for their buffers.
#pragma once

#include <string>

namespace diefill::geometry {

/// `text` with %20 and the like replaced by the characters they encode; anything else stays as it is.
std::string percent_decoded(const std::string& text);

}  // namespace diefill::geometry
