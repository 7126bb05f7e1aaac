// Forwards GLEW, and with it VTK, to OSMesa. GLEW asks glXGetProcAddressARB for every OpenGL function; the
// system's libGL would return entry points that know no OSMesa context. A definition in the executable itself
// precedes the library's, so this file is linked into every program that draws (object library
// diefill_glx_forwarding). Such a program must not also open a GLX window.
#include <GL/osmesa.h>

// The name is that of the function it replaces.
extern "C" {
// NOLINTNEXTLINE(readability-identifier-naming)
__attribute__((visibility("default"), used)) void (*glXGetProcAddressARB(const unsigned char* name))();
}

void (*glXGetProcAddressARB(const unsigned char* name))() {
  return reinterpret_cast<void (*)()>(OSMesaGetProcAddress(reinterpret_cast<const char*>(name)));
}
