#include "render/offscreen/osmesa_library.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace diefill::render {

namespace {

constexpr const char* kLibrary = "libOSMesa.so.8";

template <class Function>
void find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr)
    throw std::runtime_error(std::string("no software renderer: ") + kLibrary + " lacks " + name);
}

OsmesaLibrary opened() {
  // Never closed: its functions may still be called while static objects are destroyed.
  void* const library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw std::runtime_error(std::string("no software renderer: ") + dlerror() +
                             ": install the package libosmesa6");
  OsmesaLibrary functions;
  find(library, "OSMesaCreateContextAttribs", functions.create_context);
  find(library, "OSMesaDestroyContext", functions.destroy_context);
  find(library, "OSMesaMakeCurrent", functions.make_current);
  find(library, "OSMesaGetCurrentContext", functions.current_context);
  find(library, "OSMesaGetProcAddress", functions.address_of);
  return functions;
}

}  // namespace

const OsmesaLibrary& osmesa() {
  static const OsmesaLibrary library = opened();
  return library;
}

}  // namespace diefill::render
