// STEP and IGES by OpenCASCADE, in a shared library of its own: loading OpenCASCADE takes as long as the rest
// of the program takes to start, so it is loaded when the first such file is read (read_curved_faces.cpp).
#pragma once

#include <filesystem>

#include "geometry/cad/cad_parts.h"

/// As read_curved_faces() (cad_readers.h). In `contents`: what the file holds.
extern "C" void diefill_read_step_or_iges(const std::filesystem::path& file,
                                          const diefill::geometry::CadFormat& format, double chord_tolerance,
                                          diefill::geometry::CadParts& contents);
