// Percent-encoded names, as glTF files have them for their buffers.
#pragma once

#include <string>

namespace diefill::geometry {

/// `text` with %20 and the like as the characters that they stand for; what is no such code stays as it is.
std::string percent_decoded(const std::string& text);

}  // namespace diefill::geometry
