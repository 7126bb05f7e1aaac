#include "render/report/html.h"

#include <QString>
#include <algorithm>

#include "render/report/viewer/page_parts.h"

namespace diefill::render::report {
namespace {

/// Asks browsers to load nothing that is not inside the page, and to run nothing but `scripts`.
std::string policy(const std::string& scripts) {
  return "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
         "media-src "
         "data:; style-src 'unsafe-inline'" +
         scripts + "\">\n";
}

constexpr const char* kStyle = R"(<style>
:root { color-scheme: light; }
body { margin: 0 auto; max-width: 68rem; padding: 0 1.25rem 3rem; background: #fff; color: #1c1c1c;
  font: 16px/1.5 "DejaVu Sans", Verdana, sans-serif; overflow-wrap: break-word; }
h1 { font-size: 1.8rem; line-height: 1.2; margin: 2rem 0 .25rem; }
h2 { font-size: 1.35rem; margin: 2.5rem 0 .5rem; border-bottom: 2px solid #3b528b; padding-bottom: .2rem; }
h3 { font-size: 1.1rem; margin: 1.75rem 0 .4rem; }
p.subtitle { color: #555; margin: 0 0 1rem; }
p.remark { border-left: 4px solid #b35900; background: #fff6ea; padding: .5rem .8rem; }
nav ul { columns: 18rem; padding-left: 1.2rem; margin: .5rem 0 0; }
nav a { color: #22407a; }
.wide { overflow-x: auto; margin: .75rem 0 1.25rem; }
table { border-collapse: collapse; font-size: .9rem; width: 100%; font-variant-numeric: tabular-nums; }
p.caption { color: #555; font-size: .9rem; margin: 1rem 0 -.4rem; break-after: avoid; }
th, td { text-align: left; vertical-align: top; padding: .3rem .7rem .3rem 0; border-bottom: 1px solid #ccc;
  overflow-wrap: normal; }
thead th { border-bottom: 2px solid #777; vertical-align: bottom; }
table.numbers td, table.numbers thead th + th { text-align: right; padding-right: 0; padding-left: .8rem; }
tbody th { font-weight: normal; color: #333; min-width: 8rem; }
figure { margin: 1rem 0; break-inside: avoid; }
figure img, figure video { display: block; width: 100%; max-width: 50rem; height: auto; }
figcaption { font-size: .85rem; color: #444; margin-top: .3rem; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 25rem), 1fr)); gap: 1rem; }
.pictures figure { margin: 0; }
pre { font: .8rem/1.4 "DejaVu Sans Mono", monospace; background: #f5f5f5; padding: .8rem; white-space: pre-wrap;
  overflow-wrap: anywhere; }
@media (max-width: 40rem) { body { padding: 0 .8rem 2rem; font-size: 15px; } h1 { font-size: 1.4rem; }
  h2 { font-size: 1.2rem; } }
@media print { body { max-width: none; padding: 0; font-size: 9.5pt; } nav { display: none; }
  h2, h3 { break-after: avoid; } tr, figure { break-inside: avoid; } .wide { overflow: visible; }
  pre { background: none; border: 1px solid #ccc; } @page { margin: 16mm; } }
</style>
)";

/// A number and its scatter stay on one line.
std::string cell_text(const std::string& cell) {
  static const std::string kApart = " ± ", kTogether = "&nbsp;±&nbsp;";
  std::string text = escaped(cell);
  const auto at = text.find(kApart);
  return at == std::string::npos ? text : text.replace(at, kApart.size(), kTogether);
}

class Writer {
 public:
  void operator()(const Paragraph& paragraph) {
    page += paragraph.remark ? "<p class=\"remark\">" : "<p>";
    page += escaped(paragraph.text) + "</p>\n";
  }

  void operator()(const Table& table) {
    // Not a <caption>: on a narrow screen it would scroll out of sight with the table's columns.
    if (!table.caption.empty()) page += "<p class=\"caption\">" + escaped(table.caption) + "</p>\n";
    page += table.numbers ? "<div class=\"wide\"><table class=\"numbers\">" : "<div class=\"wide\"><table>";
    if (!table.header.empty()) {
      page += "<thead><tr>";
      for (const auto& cell : table.header) page += "<th scope=\"col\">" + escaped(cell) + "</th>";
      page += "</tr></thead>";
    }
    page += "<tbody>\n";
    for (const auto& row : table.rows) write_row(row);
    page += "</tbody></table></div>\n";
  }

  void operator()(const Figures& figures) {
    page += figures.side_by_side ? "<div class=\"pictures\">\n" : "<div>\n";
    for (const Figure& figure : figures.figures) {
      page += "<figure><img decoding=\"async\" alt=\"" + escaped(figure.caption) +
              "\" src=\"data:image/png;base64,";
      page += figure.png.toBase64().toStdString();
      page += "\"><figcaption>" + escaped(figure.caption) + "</figcaption></figure>\n";
    }
    page += "</div>\n";
  }

  void operator()(const View3D& view) { page += view_html(view); }

  void operator()(const Film& film) {
    page += "<figure><video controls loop muted src=\"data:video/mp4;base64,";
    page += film.mp4.toBase64().toStdString();
    page += "\"></video><figcaption>" + escaped(film.caption) + "</figcaption></figure>\n";
  }

  void operator()(const Listing& listing) { page += "<pre>" + escaped(listing.text) + "</pre>\n"; }

  std::string page;

 private:
  void write_row(const std::vector<std::string>& row) {
    page += "<tr>";
    for (std::size_t n = 0; n < row.size(); ++n)
      page +=
          n == 0 ? "<th scope=\"row\">" + escaped(row[n]) + "</th>" : "<td>" + cell_text(row[n]) + "</td>";
    page += "</tr>\n";
  }
};

std::string contents(const Document& document) {
  std::string list = "<nav aria-label=\"Contents\"><ul>\n";
  for (std::size_t n = 0; n < document.sections.size(); ++n)
    if (document.sections[n].level == 1)
      list += "<li><a href=\"#section-" + std::to_string(n) + "\">" + escaped(document.sections[n].title) +
              "</a></li>\n";
  return list + "</ul></nav>\n";
}

bool holds_view(const Section& section) {
  return std::any_of(section.blocks.begin(), section.blocks.end(),
                     [](const Block& block) { return std::holds_alternative<View3D>(block); });
}

}  // namespace

std::string escaped(const std::string& text) {
  const QString characters = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
  QString kept;
  for (const QChar character : characters)
    if (character == u'\n' || character == u'\t' || character.category() != QChar::Other_Control)
      kept += character;
  return kept.toHtmlEscaped().replace(u'\'', QLatin1String("&#39;")).toStdString();
}

std::string html_page(const Document& document) {
  Writer writer;
  writer.page = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  const bool views = std::any_of(document.sections.begin(), document.sections.end(), holds_view);
  writer.page += policy(views ? viewer_script_policy() : "");
  writer.page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  writer.page += "<link rel=\"icon\" href=\"data:,\">\n<title>" + escaped(document.title) + "</title>\n";
  writer.page += kStyle + (views ? viewer_style() : std::string());
  writer.page += "</head>\n<body>\n<h1>" + escaped(document.title) + "</h1>\n<p class=\"subtitle\">" +
                 escaped(document.subtitle) + "</p>\n" + contents(document) + "<main>\n";
  for (std::size_t n = 0; n < document.sections.size(); ++n) {
    const Section& section = document.sections[n];
    const std::string tag = section.level == 1 ? "h2" : "h3";
    writer.page += "<section id=\"section-" + std::to_string(n) + "\">\n<" + tag + ">" +
                   escaped(section.title) + "</" + tag + ">\n";
    for (const Block& block : section.blocks) std::visit(writer, block);
    writer.page += "</section>\n";
  }
  return writer.page + "</main>\n" + (views ? viewer_scripts() : std::string()) + "</body>\n</html>\n";
}

}  // namespace diefill::render::report
