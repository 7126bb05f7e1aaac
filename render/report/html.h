// A report as one HTML page that needs nothing else: styles, pictures, films and interactive views are
// inside, there is no reference to anywhere. Scripts are those of the views only.
#pragma once

#include <string>

#include "render/report/document.h"

namespace diefill::render::report {

/// Text with the characters that mean something in HTML replaced; bytes that are no UTF-8 become replacement
/// characters, control characters (except line ends and tabs) vanish.
std::string escaped(const std::string& text);

/// The whole page.
std::string html_page(const Document& document);

}  // namespace diefill::render::report
