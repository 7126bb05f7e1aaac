// OSMesa, opened when the first picture in three dimensions asks for it: with it comes a compiler (LLVM),
// whose loading takes a tenth of a second.
#pragma once

#include <GL/osmesa.h>

namespace diefill::render {

/// The functions of OSMesa that are used here, as GL/osmesa.h declares them.
struct OsmesaLibrary {
  decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&OSMesaDestroyContext) destroy_context = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetCurrentContext) current_context = nullptr;
  decltype(&OSMesaGetProcAddress) address_of = nullptr;  ///< of an OpenGL function, by its name
};

/// Throws std::runtime_error where the library is not installed or lacks a function.
const OsmesaLibrary& osmesa();

}  // namespace diefill::render
