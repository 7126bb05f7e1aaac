// An OpenGL context of OSMesa: draws in software into memory, needs neither display nor graphics card.
#pragma once

#include <vector>

struct osmesa_context;  // of GL/osmesa.h

namespace diefill::render {

/// An OpenGL 3.3 core context; destroyed with the object. Apart from OffscreenWindow because the headers of
/// OSMesa and GLEW do not go into one file.
class OsmesaContext {
 public:
  /// Throws std::runtime_error where OSMesa gives no such context, or where the program lacks the forwarding
  /// of gl_forwarding.cpp, without which OpenGL calls would go elsewhere.
  OsmesaContext(int width, int height);
  ~OsmesaContext();
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void make_current();
  bool is_current() const;

 private:
  int width_, height_;
  std::vector<unsigned char> pixels_;
  osmesa_context* handle_ = nullptr;
};

}  // namespace diefill::render
