#include "render/report/live_page.h"

#include <algorithm>
#include <cmath>

#include "render/report/html.h"
#include "render/report/numbers.h"

namespace diefill::render::report {
namespace {

constexpr double kWidth = 460, kHeight = 230, kLeft = 62, kRight = 14, kTop = 28, kBottom = 38;

constexpr const char* kStyle = R"(<style>
body { margin: 0 auto; max-width: 62rem; padding: 0 1.25rem 2rem; background: #fff; color: #1c1c1c;
  font: 16px/1.45 "DejaVu Sans", Verdana, sans-serif; overflow-wrap: break-word; }
h1 { font-size: 1.5rem; margin: 1.2rem 0 .2rem; }
p.subtitle { color: #555; margin: 0 0 1rem; }
.bar { height: 1.5rem; background: #e7eaf0; border-radius: 4px; overflow: hidden; }
.bar div { height: 100%; background: #3b528b; }
.state { font-weight: bold; margin: .4rem 0 1rem; }
.parts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 27rem), 1fr)); gap: 1rem 2rem; }
table { border-collapse: collapse; width: 100%; font-size: .92rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: .25rem .8rem .25rem 0; border-bottom: 1px solid #ccc; vertical-align: top; }
tbody th { font-weight: normal; color: #444; } td.number { text-align: right; }
td.exceeded { color: #a02020; font-weight: bold; }
svg, img { display: block; width: 100%; height: auto; }
figure { margin: 1rem 0; } figcaption { color: #444; font-size: .88rem; }
</style>
)";

std::string number(double value) {
  return in_digits(value, 4);
}

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" +
         escaped(text) + "</text>";
}

/// A scale from 0, or from the first value, to a round number above the last.
struct Axis {
  double lower, upper, step;
};

Axis axis_of(double lower, double upper) {
  if (!(upper > lower)) upper = lower + 1;
  const double raw = (upper - lower) / 4, power = std::pow(10, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (raw <= factor * power) step = factor * power;
  return {lower, std::ceil(upper / step - 1e-9) * step, step};
}

/// One curve as a drawing.
std::string drawing(const LiveCurve& curve) {
  const Axis x = axis_of(0, curve.x.empty() ? 1 : curve.x.back());
  const Axis y = axis_of(0, curve.y.empty() ? 1 : *std::max_element(curve.y.begin(), curve.y.end()));
  const auto across = [&](double value) { return kLeft + (kWidth - kLeft - kRight) * value / x.upper; };
  const auto up = [&](double value) {
    return kHeight - kBottom - (kHeight - kTop - kBottom) * value / y.upper;
  };
  std::string svg = "<svg viewBox=\"0 0 " + number(kWidth) + " " + number(kHeight) +
                    "\" role=\"img\" font-size=\"12\" fill=\"#222\">";
  for (double tick = 0; tick <= x.upper * 1.0001; tick += x.step)
    svg += text_at(across(tick), kHeight - kBottom + 16, "middle", number(tick));
  for (double tick = 0; tick <= y.upper * 1.0001; tick += y.step) {
    svg += "<path stroke=\"#ddd\" d=\"M" + number(kLeft) + " " + number(up(tick)) + "H" +
           number(kWidth - kRight) + "\"/>" + text_at(kLeft - 6, up(tick) + 4, "end", number(tick));
  }
  std::string line;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    line += k == 0 ? 'M' : 'L';
    line += number(across(curve.x[k])) + " " + number(up(curve.y[k]));
  }
  svg += "<path fill=\"none\" stroke=\"#3b528b\" stroke-width=\"2\" d=\"" + line + "\"/>";
  svg += text_at(kLeft, 16, "start", curve.name + " [" + curve.unit + "]") +
         text_at(kWidth - kRight, kHeight - 6, "end", "time of the scene [s]");
  return svg + "</svg>\n";
}

std::string facts_html(const LivePage& page) {
  std::string html = "<table><tbody>\n";
  for (const auto& [name, value] : page.facts)
    html += "<tr><th scope=\"row\">" + escaped(name) + "</th><td>" + escaped(value) + "</td></tr>\n";
  return html + "</tbody></table>\n";
}

std::string margins_html(const std::vector<results::Margin>& margins) {
  std::string html =
      "<table><thead><tr><th>Limit of the "
      "method</th><th>Found</th><th>Limit</th><th>Share</th></tr></thead><tbody>\n";
  for (const auto& margin : margins)
    html += "<tr><th scope=\"row\">" + escaped(margin.name) + "</th><td class=\"number\">" +
            in_digits(margin.found, 3) + "</td><td class=\"number\">" + in_digits(margin.limit, 3) +
            "</td><td class=\"number" + (margin.exceeded() ? " exceeded\">" : "\">") +
            in_digits(100 * margin.share(), 2) + " %</td></tr>\n";
  return html + "</tbody></table>\n";
}

std::string runs_html(const LivePage& page) {
  std::string html = "<table><thead><tr>";
  for (const auto& cell : page.header) html += "<th>" + escaped(cell) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (std::size_t n = 0; n < page.rows.size(); ++n) {
    html += "<tr>";
    for (std::size_t column = 0; column < page.rows[n].size(); ++column) {
      const std::string cell = escaped(page.rows[n][column]);
      const bool linked = column == 0 && n < page.links.size() && !page.links[n].empty();
      html += linked ? "<th scope=\"row\"><a href=\"" + escaped(page.links[n]) + "\">" + cell + "</a></th>"
                     : "<td>" + cell + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string picture_html(const LivePage& page) {
  const std::string caption = escaped(page.picture_caption);
  return "<figure><img alt=\"" + caption + "\" src=\"data:image/png;base64," +
         page.picture.toBase64().toStdString() + "\"><figcaption>" + caption + "</figcaption></figure>\n";
}

std::string head(const LivePage& page) {
  std::string html = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  if (!page.over) html += "<meta http-equiv=\"refresh\" content=\"" + std::to_string(kLiveRefresh) + "\">\n";
  html +=
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
      "'unsafe-inline'\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n";
  const std::string percent = std::to_string(static_cast<int>(100 * page.share)) + " %";
  return html + "<title>" + (page.over ? "" : percent + " ") + escaped(page.title) + "</title>\n" + kStyle +
         "</head>\n";
}

}  // namespace

std::string live_html(const LivePage& page) {
  std::string html =
      head(page) + "<body>\n<h1>" + escaped(page.title) + "</h1>\n<p class=\"subtitle\">" +
      escaped(page.subtitle) +
      "</p>\n<div class=\"bar\"><div style=\"width: " + number(100 * std::clamp(page.share, 0.0, 1.0)) +
      "%\"></div></div>\n<p class=\"state\">" + escaped(page.state) + "</p>\n<div class=\"parts\">\n";
  if (!page.facts.empty()) html += facts_html(page);
  if (!page.margins.empty()) html += margins_html(page.margins);
  for (const auto& curve : page.curves) html += drawing(curve);
  html += "</div>\n";
  if (!page.header.empty()) html += runs_html(page);
  if (!page.picture.isEmpty()) html += picture_html(page);
  return html + "</body>\n</html>\n";
}

}  // namespace diefill::render::report
