#include "render/fields/density_map.h"

#include <algorithm>
#include <cmath>

#include "process/results/places_without_value.h"
#include "process/results/studies/mean.h"
#include "render/fields/arrow_painter.h"
#include "render/fields/field_marks.h"
#include "render/fields/field_sampler.h"
#include "render/style/colour_map.h"
#include "render/style/picture_file.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

constexpr double kMargin = 36;
constexpr double kBarGap = 44;  // between data rectangle and colour bar
constexpr double kMapWidth = 1600, kMapHeight = 900;
constexpr double kSectionSide = 1060;  // longest side of a section's data rectangle
constexpr double kMinSide = 90;        // a thinner rectangle gives up equal scales
constexpr double kMinBar = 420;
constexpr double kMinCanvas = 1000;
constexpr double kNoteHeight = 44, kNoteLine = 32;

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
  equal_scales = std::min(width, height) * scale >= kMinSide;
  return {std::max(std::round(width * scale), kMinSide), std::max(std::round(height * scale), kMinSide)};
}

Layout lay_out_map(double heading, const PlotArea& axes, double bar_width, double foot) {
  Layout layout;
  const double left = kMargin + left_margin(axes.y), top = kMargin + heading + kMarkerBand;
  const double right = kMargin + bar_width + kBarGap, bottom = bottom_margin() + foot + kMargin;
  layout.canvas = {kMapWidth, kMapHeight};
  layout.plot = QRectF(left, std::round(top), std::round(kMapWidth - left - right),
                       std::round(kMapHeight - top - bottom));
  layout.bar = QRectF(layout.plot.right() + kBarGap, layout.plot.top() + kBarPoint, kBarWidth,
                      layout.plot.height() - 2 * kBarPoint);
  return layout;
}

Layout lay_out_section(double heading, const PlotArea& axes, double bar_width, double foot, bool equal_scales,
                       double width) {
  Layout layout;
  layout.equal_scales = equal_scales;
  const double left = kMargin + left_margin(axes.y), right = kMargin + bar_width + kBarGap;
  const QSizeF plot = axes.rect.size();
  const double body = std::max(plot.height(), kMinBar);
  const double top = kMargin + heading + 16;
  layout.canvas = {std::round(width), std::round(top + body + bottom_margin() + foot + kMargin)};
  const double indent = std::round(left + 0.5 * (width - left - right - plot.width()));
  layout.plot = QRectF(indent, std::round(top + 0.5 * (body - plot.height())), plot.width(), plot.height());
  const double bar_height = std::min(body, 900.0) - 2 * kBarPoint;
  layout.bar = QRectF(layout.plot.right() + kBarGap, std::round(top + 0.5 * (body - bar_height)), kBarWidth,
                      std::round(bar_height));
  return layout;
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

ColourBar make_bar(const results::Field2D& field, const ColourRange& range, const FieldStyle& style) {
  const std::string name = style.scale_label.empty() ? field.quantity : style.scale_label;
  const QString label = axis_label(name, style.unit);
  ColourBar bar = style.diverging ? make_diverging_bar(label, field.value, range.upper)
                                  : make_colour_bar(label, field.value, {range.lower, range.upper});
  if (style.mark_mean) bar.mark = results::mean_of_finite(field.value);
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
  if (broken_scales) add(QStringLiteral("axes have different scales"));
  return note;
}

// The note of the foot: in one line, or in two where small type is not enough.
struct FootNote {
  QString text;
  double room = 0;  // pixels
  int pixels = kNotePixels, lines = 1;
};

FootNote foot_note(const QString& text, const PlacesShown& places, double canvas_width) {
  constexpr int kTwoLines = 20;  // height of the type
  FootNote note{text, canvas_width - 2 * kMargin - (places.any() && !places.several() ? 220 : 0)};
  note.pixels = fitting_pixels(text, kNotePixels, note.room);
  if (text_width(text, text_font(note.pixels)) <= note.room) return note;
  note.pixels = kTwoLines;
  note.lines = 2;
  return note;
}

// The foot: what was averaged and marked at the left; what places without value are at the right end of that
// line, or in a line of their own above it.
void draw_foot(QPainter& painter, const QSizeF& canvas, const FootNote& note, const PlacesShown& places,
               const ColourBar& bar) {
  const double top = canvas.height() - kMargin - 30 - (note.lines - 1) * kNoteLine;
  const bool own_line = places.several();
  painter.setFont(text_font(note.pixels));
  painter.setPen(QColor(70, 70, 70));
  painter.drawText(QRectF(kMargin, top, note.room, note.lines * kNoteLine),
                   Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, note.text);
  if (!places.any()) return;
  const double left = own_line ? kMargin : canvas.width() - kMargin - places.legend_width();
  places.draw_legend(painter, {left, own_line ? top - kLegendLine + 6 : top + 2}, bar);
}

// A broken line across the data with its name at one end, below the line where there is no room above.
void draw_fill_plane(QPainter& painter, const PlotArea& plot, double height, bool at_left) {
  if (!(height >= plot.y.range.lower - 1e-6 && height <= plot.y.range.upper + 1e-6)) return;
  const double y = plot.pixel(plot.x.range.lower, height).y();
  const QColor colour(170, 0, 60);
  painter.setPen(QPen(colour, 3, Qt::DashLine, Qt::FlatCap));
  painter.drawLine(QPointF(plot.rect.left(), y), QPointF(plot.rect.right(), y));
  const QString text = QStringLiteral("fill plane");
  const QFont font = text_font(kNotePixels);
  const double width = text_width(text, font) + 12, above = y - plot.rect.top() > 40 ? y - 34 : y + 5;
  if (width > plot.rect.width()) return;
  const QRectF label(at_left ? plot.rect.left() + 8 : plot.rect.right() - width - 8, above, width, 29);
  painter.fillRect(label, QColor(255, 255, 255, 225));
  painter.setFont(font);
  painter.setPen(colour);
  painter.drawText(label, Qt::AlignCenter, text);
}

// What of the field has no value, pixel by pixel: what paint_field will show.
PlacesShown places_shown(const results::Field2D& field, const FieldStyle& style) {
  PlacesShown places;
  for (std::size_t n = 0; n < field.value.size(); ++n)
    places.add(place_of(field.value[n], field.first[n % field.first.size()],
                        field.second[n / field.first.size()], style));
  return places;
}

// Lines, arrows, axes and remarks over the coloured field.
void draw_on_field(QPainter& painter, const PlotArea& plot, const QSizeF& canvas,
                   const results::Field2D& field, const FieldStyle& style) {
  draw_outlines(painter, plot, style.outlines);
  draw_fill_plane(painter, plot, style.fill_plane, !style.arrows.empty());
  draw_arrows(painter, plot, style);
  draw_axes(painter, plot, canvas);
  draw_field_marks(painter, plot, field, style);
  if (has_azimuth(field)) draw_markers(painter, plot, shoe_markers());
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

namespace {

/// Where a line of pixels goes into the tools and comes out of them, by their outlines. Tools may overlap.
class ToolCrossings {
 public:
  ToolCrossings(const std::vector<Outline>& outlines, double second) {
    for (const Outline& outline : outlines)
      for (std::size_t k = 1; k < outline.size(); ++k) {
        const auto &from = outline[k - 1], &to = outline[k];
        if ((from.y() > second) == (to.y() > second)) continue;
        const double first = from.x() + (second - from.y()) / (to.y() - from.y()) * (to.x() - from.x());
        crossings_.push_back({first, to.y() > from.y() ? 1 : -1});
      }
    std::ranges::sort(crossings_, {}, &Crossing::first);
    int depth = 0;
    for (Crossing& crossing : crossings_) crossing.depth = depth += crossing.depth;
  }

  bool inside(double first) const {
    const auto next = std::ranges::upper_bound(crossings_, first, {}, &Crossing::first);
    return next != crossings_.begin() && std::prev(next)->depth != 0;
  }

 private:
  struct Crossing {
    double first;
    int depth;  ///< number of solids behind it, with the sign of their outlines' direction
  };
  std::vector<Crossing> crossings_;
};

/// What the field has at a place of the picture. Its nodes know tools to half their distance, outlines know
/// them exactly.
double value_at(const FieldSampler& sampler, const std::vector<ToolCrossings>& levels, const QPointF& at) {
  const double value = sampler.at(at.x(), at.y());
  if (levels.empty()) return value;
  if (std::ranges::all_of(levels, [&](const ToolCrossings& tools) { return tools.inside(at.x()); }))
    return results::inside_tool();
  return results::is_inside_tool(value) ? sampler.at_outside_tools(at.x(), at.y()) : value;
}

PlotArea labelled_axes(const results::Field2D& field, const QSizeF& size, const FieldStyle& style) {
  PlotArea axes = field_axes(field, size);
  if (!style.first_label.empty()) axes.x.label = axis_label(style.first_label, field.first_unit);
  if (!style.second_label.empty()) axes.y.label = axis_label(style.second_label, field.second_unit);
  return axes;
}

bool has_values(const results::Field2D& field) {
  return std::ranges::any_of(field.value, [](double value) { return std::isfinite(value); });
}

/// The colour bar; words in the field where there is nothing to be coloured.
void draw_bar(QPainter& painter, const FieldPicture& picture, const PlacesShown& places) {
  if (!picture.bar_rect.isEmpty()) return draw_colour_bar(painter, picture.bar, picture.bar_rect);
  const QString text = places.several() ? QStringLiteral("no value") : QStringLiteral("no powder");
  QRectF plate(0, 0, text_width(text, text_font(kLabelPixels)) + 24, 1.5 * kLabelPixels);
  plate.moveCenter(picture.plot.rect.center());
  painter.fillRect(plate.intersected(picture.plot.rect), QColor(255, 255, 255, 225));
  draw_centred(painter, picture.plot.rect.center(), text, kLabelPixels, picture.plot.rect.width());
}

}  // namespace

PlacesShown paint_field(QImage& canvas, const PlotArea& plot, const results::Field2D& field,
                        const ColourBar& bar, const FieldStyle& style) {
  const results::Field2D round = continued_round(field);
  const FieldSampler sampler(round);
  PlacesShown places;
  const double pixels = canvas.devicePixelRatio();
  const QRect rect = QRectF(plot.rect.topLeft() * pixels, plot.rect.size() * pixels).toRect();
  for (int row = rect.top(); row <= rect.bottom(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(canvas.scanLine(row));
    std::vector<ToolCrossings> levels;
    for (const auto& outlines : style.tool_levels)
      levels.emplace_back(outlines, plot.value({0, (row + 0.5) / pixels}).y());
    for (int column = rect.left(); column <= rect.right(); ++column) {
      const QPointF at = plot.value({(column + 0.5) / pixels, (row + 0.5) / pixels});
      const double value = value_at(sampler, levels, at);
      const Place place = place_of(value, at.x(), at.y(), style);
      places.add(place);
      const Rgb colour = bar_colour(bar, value);
      line[column] = place == Place::kValue ? qRgb(colour.red, colour.green, colour.blue)
                                            : place_colour(place, bar, column, row);
    }
  }
  return places;
}

FieldPicture compose_field(const results::Field2D& field, const std::string& title,
                           const std::string& subtitle, const ColourRange& range, const FieldStyle& style) {
  check_field(field);
  FieldPicture picture;
  picture.bar = make_bar(field, range, style);
  const PlacesShown places = places_shown(field, style);
  picture.has_holes = places.any();

  const double bar_width = colour_bar_width(picture.bar);
  bool equal_scales = false;
  const bool is_section = same_scales(field);
  const QSizeF size = is_section ? plot_size(field, equal_scales) : QSizeF(1200, 560);
  picture.plot = labelled_axes(field, size, style);
  double width = kMapWidth;
  if (is_section)
    width = std::max({kMinCanvas, 2 * kMargin + places.legend_width(),
                      2 * kMargin + left_margin(picture.plot.y) + size.width() + kBarGap + bar_width});
  const FootNote note =
      foot_note(note_text(field, style, picture.bar, is_section && !equal_scales), places, width);
  const double foot = kNoteHeight + (note.lines - 1) * kNoteLine + (places.several() ? kLegendLine : 0);
  const Heading heading(title, subtitle, width - 2 * kMargin);
  const double head = heading.height() + marks_legend_height(style);
  const Layout layout = is_section ? lay_out_section(head, picture.plot, bar_width, foot, equal_scales, width)
                                   : lay_out_map(head, picture.plot, bar_width, foot);
  picture.plot.rect = layout.plot;
  picture.image = white_canvas(static_cast<int>(layout.canvas.width()),
                               static_cast<int>(layout.canvas.height()), style.pixels);
  paint_field(picture.image, picture.plot, field, picture.bar, style);

  QPainter painter(&picture.image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  heading.draw(painter, kMargin, kMargin - 8);
  draw_marks_legend(painter, {kMargin, kMargin + heading.height()}, style);
  draw_on_field(painter, picture.plot, layout.canvas, field, style);
  if (has_values(field)) picture.bar_rect = layout.bar;
  draw_bar(painter, picture, places);
  draw_foot(painter, layout.canvas, note, places, picture.bar);
  return picture;
}

void draw_field(const std::filesystem::path& png, const results::Field2D& field, const std::string& title,
                const std::string& subtitle, const ColourRange& range) {
  write_png(png, compose_field(field, title, subtitle, range).image);
}

}  // namespace diefill::render
