#include "render/report/sections/versions.h"

#include <QtGlobal>

namespace diefill::render::report {

std::string drawing_versions() {
  return std::string("Qt ") + qVersion();
}

}  // namespace diefill::render::report
