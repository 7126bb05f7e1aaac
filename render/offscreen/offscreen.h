// A VTK window in memory: an OSMesa context, so that no display is needed.
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

#include <memory>

namespace diefill::render {

class OsmesaContext;

/// Draws into memory. Make it with New(), then open(); everything else is a vtkRenderWindow.
class OffscreenWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static OffscreenWindow* New();
  vtkTypeMacro(OffscreenWindow, vtkGenericOpenGLRenderWindow)

      /// Creates the context for pictures of width x height pixels. Throws std::runtime_error when there is
      /// no software renderer, or the program lacks the forwarding of gl_forwarding.cpp.
      void open(int width, int height);

  void MakeCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override { return 1; }
  void Frame() override {}
  void OpenGLInitContext() override;

 protected:
  OffscreenWindow();
  ~OffscreenWindow() override;

 private:
  std::unique_ptr<OsmesaContext> context_;
};

}  // namespace diefill::render
