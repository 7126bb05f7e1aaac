// Forwards VTK and GLEW to OSMesa. Both ask for OpenGL functions by their names, of which the system's libGL
// would return ones that know no OSMesa context: those of OpenGL 1.1 as symbols, all others through
// glXGetProcAddressARB. Definitions in the executable itself precede a library's, so this file is linked into
// every program that draws (object library diefill_gl_forwarding). Such a program must not also open a GLX
// window.
#include <stdexcept>
#include <string>

#include "render/offscreen/osmesa_library.h"

namespace {

template <class Function>
Function* forwarded(const char* name) {
  const auto address = diefill::render::osmesa().address_of(name);
  if (address == nullptr) throw std::runtime_error(std::string("no software renderer: OSMesa lacks ") + name);
  return reinterpret_cast<Function*>(address);
}

}  // namespace

// Names are those of the functions that are replaced; GL/gl.h declares all but one.
// NOLINTBEGIN(readability-identifier-naming)
#define DIEFILL_FORWARD(result, name, parameters, arguments)                       \
  extern "C" __attribute__((visibility("default"), used)) result name parameters { \
    static auto* const function = forwarded<result parameters>(#name);             \
    return function arguments;                                                     \
  }

extern "C"
    __attribute__((visibility("default"), used)) void (*glXGetProcAddressARB(const unsigned char* name))() {
  return reinterpret_cast<void (*)()>(
      diefill::render::osmesa().address_of(reinterpret_cast<const char*>(name)));
}

DIEFILL_FORWARD(void, glBindTexture, (GLenum a, GLuint b), (a, b))
DIEFILL_FORWARD(void, glClear, (GLbitfield a), (a))
DIEFILL_FORWARD(void, glClearColor, (GLclampf a, GLclampf b, GLclampf c, GLclampf d), (a, b, c, d))
DIEFILL_FORWARD(void, glClearDepth, (GLclampd a), (a))
DIEFILL_FORWARD(void, glClearStencil, (GLint a), (a))
DIEFILL_FORWARD(void, glColorMask, (GLboolean a, GLboolean b, GLboolean c, GLboolean d), (a, b, c, d))
DIEFILL_FORWARD(void, glCopyTexImage2D,
                (GLenum a, GLint b, GLenum c, GLint d, GLint e, GLsizei f, GLsizei g, GLint h),
                (a, b, c, d, e, f, g, h))
DIEFILL_FORWARD(void, glCullFace, (GLenum a), (a))
DIEFILL_FORWARD(void, glDeleteTextures, (GLsizei a, const GLuint* b), (a, b))
DIEFILL_FORWARD(void, glDepthFunc, (GLenum a), (a))
DIEFILL_FORWARD(void, glDepthMask, (GLboolean a), (a))
DIEFILL_FORWARD(void, glDisable, (GLenum a), (a))
DIEFILL_FORWARD(void, glDrawArrays, (GLenum a, GLint b, GLsizei c), (a, b, c))
DIEFILL_FORWARD(void, glDrawElements, (GLenum a, GLsizei b, GLenum c, const GLvoid* d), (a, b, c, d))
DIEFILL_FORWARD(void, glEnable, (GLenum a), (a))
DIEFILL_FORWARD(void, glFinish, (), ())
DIEFILL_FORWARD(void, glFlush, (), ())
DIEFILL_FORWARD(void, glGenTextures, (GLsizei a, GLuint* b), (a, b))
DIEFILL_FORWARD(void, glGetBooleanv, (GLenum a, GLboolean* b), (a, b))
DIEFILL_FORWARD(void, glGetDoublev, (GLenum a, GLdouble* b), (a, b))
DIEFILL_FORWARD(GLenum, glGetError, (), ())
DIEFILL_FORWARD(void, glGetFloatv, (GLenum a, GLfloat* b), (a, b))
DIEFILL_FORWARD(void, glGetIntegerv, (GLenum a, GLint* b), (a, b))
DIEFILL_FORWARD(const GLubyte*, glGetString, (GLenum a), (a))
DIEFILL_FORWARD(void, glGetTexImage, (GLenum a, GLint b, GLenum c, GLenum d, GLvoid* e), (a, b, c, d, e))
DIEFILL_FORWARD(void, glGetTexLevelParameteriv, (GLenum a, GLint b, GLenum c, GLint* d), (a, b, c, d))
DIEFILL_FORWARD(GLboolean, glIsEnabled, (GLenum a), (a))
DIEFILL_FORWARD(void, glLineWidth, (GLfloat a), (a))
DIEFILL_FORWARD(void, glPixelStorei, (GLenum a, GLint b), (a, b))
DIEFILL_FORWARD(void, glPointSize, (GLfloat a), (a))
DIEFILL_FORWARD(void, glReadBuffer, (GLenum a), (a))
DIEFILL_FORWARD(void, glReadPixels, (GLint a, GLint b, GLsizei c, GLsizei d, GLenum e, GLenum f, GLvoid* g),
                (a, b, c, d, e, f, g))
DIEFILL_FORWARD(void, glScissor, (GLint a, GLint b, GLsizei c, GLsizei d), (a, b, c, d))
DIEFILL_FORWARD(void, glTexEnvi, (GLenum a, GLenum b, GLint c), (a, b, c))
DIEFILL_FORWARD(void, glTexImage1D,
                (GLenum a, GLint b, GLint c, GLsizei d, GLint e, GLenum f, GLenum g, const GLvoid* h),
                (a, b, c, d, e, f, g, h))
DIEFILL_FORWARD(void, glTexImage2D,
                (GLenum a, GLint b, GLint c, GLsizei d, GLsizei e, GLint f, GLenum g, GLenum h,
                 const GLvoid* i),
                (a, b, c, d, e, f, g, h, i))
DIEFILL_FORWARD(void, glTexParameterf, (GLenum a, GLenum b, GLfloat c), (a, b, c))
DIEFILL_FORWARD(void, glTexParameterfv, (GLenum a, GLenum b, const GLfloat* c), (a, b, c))
DIEFILL_FORWARD(void, glTexParameteri, (GLenum a, GLenum b, GLint c), (a, b, c))
DIEFILL_FORWARD(void, glViewport, (GLint a, GLint b, GLsizei c, GLsizei d), (a, b, c, d))
// NOLINTEND(readability-identifier-naming)
