#include "render/offscreen/offscreen.h"

#include <GL/glew.h>
#include <vtkObjectFactory.h>

#include <stdexcept>

#include "render/offscreen/osmesa_context.h"

namespace diefill::render {

vtkStandardNewMacro(OffscreenWindow)

    OffscreenWindow::OffscreenWindow() = default;

OffscreenWindow::~OffscreenWindow() {
  if (!context_) return;
  MakeCurrent();
  Finalize();
}

void OffscreenWindow::open(int width, int height) {
  context_ = std::make_unique<OsmesaContext>(width, height);
  SetSize(width, height);
  SetMapped(1);
  SetReadyForRendering(true);
  SetOwnContext(0);
  SetMultiSamples(0);
  SetFrameBlitModeToNoBlit();
  OpenGLInit();
  if (!GlewInitValid) throw std::runtime_error("no software renderer: OSMesa lacks OpenGL 3.2");
}

void OffscreenWindow::MakeCurrent() {
  if (context_ && !context_->is_current()) context_->make_current();
}

bool OffscreenWindow::IsCurrent() {
  return context_ && context_->is_current();
}

void OffscreenWindow::OpenGLInitContext() {
  if (Initialized) return;
  ContextCreationTime.Modified();
  MakeCurrent();
  glewExperimental = GL_TRUE;
  glewInit();  // its return code refers to GLX, which is not used here
  GlewInitValid = GLEW_VERSION_3_2;
  Initialized = true;
}

}  // namespace diefill::render
