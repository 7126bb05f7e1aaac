#include "render/offscreen/osmesa_context.h"

#include <stdexcept>

#include "render/offscreen/osmesa_library.h"

extern "C" void (*glXGetProcAddressARB(const unsigned char* name))();

namespace diefill::render {
namespace {

constexpr std::size_t kChannels = 4;

void check_forwarding() {
  constexpr const char* kProbe = "glGenFramebuffers";
  const auto given = glXGetProcAddressARB(reinterpret_cast<const unsigned char*>(kProbe));
  if (given != reinterpret_cast<void (*)()>(osmesa().address_of(kProbe)))
    throw std::runtime_error("no software renderer: this program was linked without diefill_gl_forwarding");
}

}  // namespace

OsmesaContext::OsmesaContext(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * kChannels) {
  check_forwarding();
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  handle_ = osmesa().create_context(attributes, nullptr);
  if (!handle_)
    throw std::runtime_error("no software renderer: OSMesa cannot create an OpenGL 3.3 context (libosmesa6)");
}

OsmesaContext::~OsmesaContext() {
  osmesa().destroy_context(handle_);
}

void OsmesaContext::make_current() {
  osmesa().make_current(handle_, pixels_.data(), GL_UNSIGNED_BYTE, width_, height_);
}

bool OsmesaContext::is_current() const {
  return osmesa().current_context() == handle_;
}

}  // namespace diefill::render
