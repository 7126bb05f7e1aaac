// STEP and IGES by OpenCASCADE, in a shared library of its own: loading OpenCASCADE takes as long as the rest
// of the program takes to start, so it is loaded when the first such file is read (read_curved_faces.cpp).
#pragma once

#include <filesystem>

#include "geometry/cad/cad_parts.h"

/// As read_curved_faces() (cad_readers.h). `step`: the text of a STEP file in UTF-8, without a mark of it; an
/// IGES file is read by its name. In `contents`: what the file holds.
extern "C" void diefill_read_step_or_iges(const std::filesystem::path& file, const std::string& step,
                                          const diefill::geometry::CadFormat& format, double chord_tolerance,
                                          diefill::geometry::CadParts& contents);
