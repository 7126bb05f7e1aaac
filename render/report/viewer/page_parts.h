// What a page with interactive views holds besides their data: scripts, style, and which scripts may run.
// Scripts and style are files of viewer/page/ and three.js, built into the program.
#pragma once

#include <string>

#include "render/report/document.h"

namespace diefill::render::report {

/// Rules of style for views.
std::string viewer_style();

/// The script elements that bring the page's views to life; they belong at the end of its body.
std::string viewer_scripts();

/// What the page's content security policy must allow so that these scripts run and no other.
std::string viewer_script_policy();

/// A view as HTML: data, still pictures that stand until the view does, remark.
std::string view_html(const View3D& view);

}  // namespace diefill::render::report
