// Text STL without a library: CAD programs write it in capitals, with names that contain blanks, and with
// normals that are not numbers, of which libraries accept only some. Only names and corners are read; the
// order of the corners says which side is outside.
#pragma once

#include <string>
#include <string_view>

#include "geometry/cad/cad_parts.h"

namespace diefill::geometry {

/// Whether `bytes` are text that begins with the word `solid` and continues with facets or their end; binary
/// files may begin with that word too. A mark of UTF-8 at the beginning is passed over.
bool is_text_stl(const std::string& bytes);

/// Every `solid` as a part, called by the rest of its line. Facets with more than three corners become
/// several triangles; comments after `#` or `;`, normals and unknown words are passed over. Throws
/// std::runtime_error with the line where a corner is not three numbers or a facet has fewer than three
/// corners.
CadParts read_text_stl(const std::string& bytes);

/// The number at the beginning of `word`, which it must fill: with a plus sign, and an exponent after E or D
/// of either case. False where it is none.
bool is_number(std::string_view word, double& number);

}  // namespace diefill::geometry
