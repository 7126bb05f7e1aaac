#include "render/report/viewer/page_parts.h"

#include <QCryptographicHash>
#include <QFile>
#include <stdexcept>
#include <vector>

#include "render/report/html.h"

/// Makes the built-in files known where the linker would leave them out of a static library.
static void make_files_known() {
  Q_INIT_RESOURCE(viewer);
}

namespace diefill::render::report {
namespace {

/// In the order in which they use each other.
const char* const kOwnScripts[] = {"numbers.js", "data.js",  "colours.js", "grains.js",  "tools.js",
                                   "field.js",   "zones.js", "camera.js",  "pointer.js", "panel.js",
                                   "marks.js",   "view.js",  "start.js"};

std::string built_in(const std::string& name) {
  make_files_known();
  QFile file(QString::fromStdString(":/viewer/" + name));
  if (!file.open(QIODevice::ReadOnly)) throw std::logic_error(name + " is not built into the program");
  return file.readAll().toStdString();
}

/// The scripts as they stand in the page: the library, its camera control, and ours as one.
std::vector<std::string> scripts() {
  std::string ours = "(function () {\n\"use strict\";\n";
  for (const char* name : kOwnScripts) ours += built_in(name);
  return {built_in("three.min.js"), built_in("OrbitControls.js"), ours + "})();\n"};
}

std::string picture_html(const Figure& figure) {
  const std::string caption = escaped(figure.caption);
  return "<figure><img alt=\"" + caption + "\" src=\"data:image/png;base64," +
         figure.png.toBase64().toStdString() + "\"><figcaption>" + caption + "</figcaption></figure>\n";
}

/// JSON inside a script element: nothing in it may look like the element's end.
std::string embedded(const QByteArray& json) {
  return QByteArray(json).replace('<', "\\u003c").toStdString();
}

}  // namespace

std::string viewer_style() {
  return "<style>\n" + built_in("viewer.css") + "</style>\n";
}

std::string viewer_scripts() {
  std::string html;
  for (const auto& script : scripts()) html += "<script>" + script + "</script>\n";
  return html;
}

std::string viewer_script_policy() {
  std::string policy = "; script-src";
  for (const auto& script : scripts()) {
    const auto hash = QCryptographicHash::hash(QByteArray::fromStdString(script), QCryptographicHash::Sha256);
    policy += " 'sha256-" + hash.toBase64().toStdString() + "'";
  }
  return policy;
}

std::string view_html(const View3D& view) {
  std::string html = "<div class=\"view3d\">\n<div class=\"pictures still\">\n";
  for (const auto& still : view.stills) html += picture_html(still);
  html += "</div>\n<script type=\"application/json\" class=\"description\">" + embedded(view.description) +
          "</script>\n";
  for (const auto& data : view.data)
    html += "<script type=\"text/plain\" class=\"data\">" + data.toStdString() + "</script>\n";
  if (!view.remark.empty()) html += "<p>" + escaped(view.remark) + "</p>\n";
  return html + "</div>\n";
}

}  // namespace diefill::render::report
