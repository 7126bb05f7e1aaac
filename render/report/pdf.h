// A report as a PDF in A4, set by Qt: pages with numbers, pictures and tables kept within them.
#pragma once

#include <string>

#include "render/report/document.h"

namespace diefill::render::report {

/// The bytes of the PDF. start_offscreen() must have been called. Throws std::runtime_error where Qt cannot
/// make one.
std::string pdf_pages(const Document& document);

}  // namespace diefill::render::report
