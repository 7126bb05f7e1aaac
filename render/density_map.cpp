#include "render/density_map.h"

#include <algorithm>
#include <cmath>

#include "render/arrow_painter.h"
#include "render/colour_map.h"
#include "render/field_sampler.h"
#include "render/picture_file.h"
#include "render/text.h"

namespace diefill::render {
namespace {

constexpr double kMargin = 36;
constexpr double kBarGap = 44;  // between data rectangle and colour bar
constexpr double kMapWidth = 1600, kMapHeight = 900;
constexpr double kSectionSide = 1060;  // longest side of a section's data rectangle
constexpr double kLeastSide = 90;      // a thinner rectangle gives up equal scales
constexpr double kLeastBar = 420;
constexpr double kLeastCanvas = 1000;
constexpr double kNoteHeight = 44;

struct Layout {
  QSizeF canvas;
  QRectF plot, bar;
  bool equal_scales = false;
};

bool same_scales(const results::Field2D& field) {
  return field.first_unit == field.second_unit;
}

// Longer rectangles take more ticks; a tick label of an x axis takes some 130 pixels, of a y axis some 60.
int tick_count(double pixels, double pixels_per_tick) {
  return std::clamp(static_cast<int>(pixels / pixels_per_tick) + 1, 2, 13);
}

// Size of the data rectangle: the given one, or with equal scales as large as fits a square.
QSizeF plot_size(const results::Field2D& field, bool& equal_scales) {
  const double width = field.first.back() - field.first.front();
  const double height = field.second.back() - field.second.front();
  const double scale = kSectionSide / std::max(width, height);
  equal_scales = std::min(width, height) * scale >= kLeastSide;
  return {std::max(std::round(width * scale), kLeastSide), std::max(std::round(height * scale), kLeastSide)};
}

Layout lay_out_map(double heading, const PlotArea& axes, double bar_width) {
  Layout layout;
  const double left = kMargin + left_margin(axes.y), top = kMargin + heading + kMarkerBand;
  const double right = kMargin + bar_width + kBarGap, bottom = bottom_margin() + kNoteHeight + kMargin;
  layout.canvas = {kMapWidth, kMapHeight};
  layout.plot = QRectF(left, std::round(top), std::round(kMapWidth - left - right),
                       std::round(kMapHeight - top - bottom));
  layout.bar = QRectF(layout.plot.right() + kBarGap, layout.plot.top() + kBarPoint, kBarWidth,
                      layout.plot.height() - 2 * kBarPoint);
  return layout;
}

Layout lay_out_section(double heading, const PlotArea& axes, double bar_width, bool equal_scales) {
  Layout layout;
  layout.equal_scales = equal_scales;
  const double left = kMargin + left_margin(axes.y), right = kMargin + bar_width + kBarGap;
  const QSizeF plot = axes.rect.size();
  const double body = std::max(plot.height(), kLeastBar);
  const double width = std::max(kLeastCanvas, left + plot.width() + right);
  const double top = kMargin + heading + 16;
  layout.canvas = {std::round(width), std::round(top + body + bottom_margin() + kNoteHeight + kMargin)};
  const double indent = std::round(left + 0.5 * (width - left - right - plot.width()));
  layout.plot = QRectF(indent, std::round(top + 0.5 * (body - plot.height())), plot.width(), plot.height());
  const double bar_height = std::min(body, 900.0) - 2 * kBarPoint;
  layout.bar = QRectF(layout.plot.right() + kBarGap, std::round(top + 0.5 * (body - bar_height)), kBarWidth,
                      std::round(bar_height));
  return layout;
}

// Without value: grey; where white means "no change", with lines across, so that the two are told apart.
QRgb hole_colour(const ColourBar& bar, int column, int row) {
  const bool hatched = bar.colours == ColourScale::kDiverging && (column + row) % 14 < 3;
  const int grey = hatched ? 150 : kNoValueColour.red;
  return qRgb(grey, grey, grey);
}

void draw_outlines(QPainter& painter, const PlotArea& plot, const std::vector<Outline>& outlines) {
  painter.save();
  painter.setClipRect(plot.rect);
  painter.setPen(QPen(QColor(40, 40, 40), 2.5));
  painter.setBrush(Qt::NoBrush);
  for (const Outline& outline : outlines) {
    QPolygonF line;
    for (const auto& point : outline) line << plot.pixel(point.x(), point.y());
    painter.drawPolyline(line);
  }
  painter.restore();
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  std::size_t count = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    sum += value;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : std::nan("");
}

ColourBar make_bar(const results::Field2D& field, const ColourRange& range, const FieldStyle& style) {
  const std::string name = style.scale_label.empty() ? field.quantity : style.scale_label;
  const QString label = axis_label(name, style.unit);
  ColourBar bar = style.diverging ? make_diverging_bar(label, field.value, range.upper)
                                  : make_colour_bar(label, field.value, {range.lower, range.upper});
  if (style.mark_mean) bar.mark = mean_of(field.value);
  return bar;
}

QString note_text(const results::Field2D& field, const FieldStyle& style, const ColourBar& bar,
                  bool broken_scales) {
  QString note;
  const auto add = [&note](const QString& part) { note += (note.isEmpty() ? "" : "; ") + part; };
  if (std::isfinite(bar.mark))
    add(QStringLiteral("▸ mean over the map's cells %1")
            .arg(QString::fromStdString(tick_label(bar.mark, bar.range.length() / 100))));
  if (field.averaging_width > 0)
    add(QStringLiteral("Gaussian average, σ = %1 mm").arg(field.averaging_width * 1e3, 0, 'g', 3));
  if (!style.note.empty()) add(QString::fromStdString(style.note));
  if (broken_scales) add(QStringLiteral("axes not to the same scale"));
  return note;
}

// The line at the foot: averaging width at the left, what the grey means at the right end of it.
void draw_foot(QPainter& painter, const QSizeF& canvas, const QString& note, bool has_holes, bool hatched) {
  const double top = canvas.height() - kMargin - 30;
  painter.setFont(text_font(kNotePixels));
  painter.setPen(QColor(70, 70, 70));
  const double room = canvas.width() - 2 * kMargin - (has_holes ? 220 : 0);
  QFont font = text_font(kNotePixels);
  for (int pixels = kNotePixels; pixels > 16 && text_width(note, font) > room;) font = text_font(--pixels);
  painter.setFont(font);
  painter.drawText(QRectF(kMargin, top, room, 32), Qt::AlignLeft | Qt::AlignVCenter, note);
  if (!has_holes) return;
  const QString text = QStringLiteral("no powder");
  const double width = 38 + text_width(text, text_font(kNotePixels));
  const QColor grey(kNoValueColour.red, kNoValueColour.green, kNoValueColour.blue);
  const QPointF corner(canvas.width() - kMargin - width, top + 2);
  draw_swatch(painter, corner, grey, text);
  if (hatched)
    painter.fillRect(QRectF(corner, QSizeF(28, 28)), QBrush(QColor(120, 120, 120), Qt::BDiagPattern));
}

}  // namespace

PlotArea field_axes(const results::Field2D& field, const QSizeF& size) {
  PlotArea area;
  area.rect = QRectF(QPointF(0, 0), size);
  area.x.label = axis_label(field.first_name, field.first_unit);
  area.y.label = axis_label(field.second_name, field.second_unit);
  area.x.range = {field.first.front(), field.first.back()};
  area.y.range = {field.second.front(), field.second.back()};
  if (has_azimuth(field)) {
    area.x.range = {0, 360};
    if (field.second_name == "height")
      area.y.label = axis_label("height above cavity floor", field.second_unit);
    area.x.ticks = angle_ticks(area.x.range, 9);
  } else {
    area.x.ticks = nice_ticks(area.x.range, tick_count(size.width(), 130));
  }
  area.y.ticks = nice_ticks(area.y.range, std::min(9, tick_count(size.height(), 75)));
  return area;
}

void paint_field(QImage& canvas, const PlotArea& plot, const results::Field2D& field, const ColourBar& bar) {
  const results::Field2D round = continued_round(field);
  const FieldSampler sampler(round);
  const double pixels = canvas.devicePixelRatio();
  const QRect rect = QRectF(plot.rect.topLeft() * pixels, plot.rect.size() * pixels).toRect();
  for (int row = rect.top(); row <= rect.bottom(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(canvas.scanLine(row));
    for (int column = rect.left(); column <= rect.right(); ++column) {
      const QPointF place = plot.value({(column + 0.5) / pixels, (row + 0.5) / pixels});
      const double value = sampler.at(place.x(), place.y());
      const Rgb colour = bar_colour(bar, value);
      line[column] =
          std::isnan(value) ? hole_colour(bar, column, row) : qRgb(colour.red, colour.green, colour.blue);
    }
  }
}

FieldPicture compose_field(const results::Field2D& field, const std::string& title,
                           const std::string& subtitle, const ColourRange& range, const FieldStyle& style) {
  check_field(field);
  FieldPicture picture;
  picture.bar = make_bar(field, range, style);
  const auto is_hole = [](double value) { return !std::isfinite(value); };
  picture.has_holes = std::any_of(field.value.begin(), field.value.end(), is_hole);
  const bool is_empty = std::all_of(field.value.begin(), field.value.end(), is_hole);

  const double bar_width = colour_bar_width(picture.bar);
  bool equal_scales = false;
  const bool is_section = same_scales(field);
  const QSizeF size = is_section ? plot_size(field, equal_scales) : QSizeF(1200, 560);
  picture.plot = field_axes(field, size);
  double width = kMapWidth;
  if (is_section)
    width = std::max(kLeastCanvas,
                     2 * kMargin + left_margin(picture.plot.y) + size.width() + kBarGap + bar_width);
  const Heading heading(title, subtitle, width - 2 * kMargin);
  const Layout layout = is_section ? lay_out_section(heading.height(), picture.plot, bar_width, equal_scales)
                                   : lay_out_map(heading.height(), picture.plot, bar_width);
  picture.plot.rect = layout.plot;
  picture.image = white_canvas(static_cast<int>(layout.canvas.width()),
                               static_cast<int>(layout.canvas.height()), style.pixels);
  paint_field(picture.image, picture.plot, field, picture.bar);

  QPainter painter(&picture.image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  heading.draw(painter, kMargin, kMargin - 8);
  draw_outlines(painter, picture.plot, style.outlines);
  draw_arrows(painter, picture.plot, style);
  draw_axes(painter, picture.plot, layout.canvas);
  if (has_azimuth(field)) draw_markers(painter, picture.plot, shoe_markers());
  if (is_empty) {
    draw_centred(painter, layout.plot.center(), QStringLiteral("no powder"), kLabelPixels,
                 layout.plot.width());
  } else {
    picture.bar_rect = layout.bar;
    draw_colour_bar(painter, picture.bar, layout.bar);
  }
  draw_foot(painter, layout.canvas, note_text(field, style, picture.bar, is_section && !equal_scales),
            picture.has_holes, style.diverging);
  return picture;
}

void draw_field(const std::filesystem::path& png, const results::Field2D& field, const std::string& title,
                const std::string& subtitle, const ColourRange& range) {
  write_png(png, compose_field(field, title, subtitle, range).image);
}

}  // namespace diefill::render
