// The libraries that drew a report.
#pragma once

#include <string>

namespace diefill::render::report {

/// Such as "VTK 9.1.0, Qt 6.4.2".
std::string drawing_versions();

}  // namespace diefill::render::report
