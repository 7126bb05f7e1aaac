#include "render/fields/comparison_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "render/fields/density_map.h"
#include "render/fields/field_sampler.h"
#include "render/style/colour_map.h"
#include "render/style/picture_file.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

constexpr double kWidth = 1800, kMargin = 36, kGap = 44;
constexpr double kNameBand = 46;  // above each panel
constexpr double kTallest = 420, kLowest = 150;
constexpr double kFoot = 60;

/// Where the panels stand.
struct Grid {
  std::size_t columns = 1, rows = 1;
  double left = 0, top = 0, width = 0, height = 0;  ///< of the first data rectangle
  double step_x = 0, step_y = 0;
  double bottom() const { return top + static_cast<double>(rows - 1) * step_y + height; }
  QRectF rect(std::size_t k) const {
    return {std::round(left + static_cast<double>(k % columns) * step_x),
            std::round(top + static_cast<double>(k / columns) * step_y), width, height};
  }
  /// Pixels from the left end of a panel to the next one, or to the colour scale.
  double room_for_name(std::size_t k) const {
    return step_x - (k % columns + 1 < columns ? kGap : left - kMargin);
  }
};

/// What stands above a panel, and the height of its type in pixels.
struct PanelName {
  std::string text;
  int pixels;
};

std::size_t columns_for(std::size_t fields) {
  return fields <= 1 ? 1 : fields <= 8 ? 2 : 3;
}

/// Axes that hold all fields, so that equal heights stand level.
PlotArea common_axes(const std::vector<ComparedField>& fields, const QSizeF& size) {
  results::Field2D all = fields.front().field;
  for (const auto& [name, field, seeds] : fields) {
    all.first.front() = std::min(all.first.front(), field.first.front());
    all.first.back() = std::max(all.first.back(), field.first.back());
    all.second.front() = std::min(all.second.front(), field.second.front());
    all.second.back() = std::max(all.second.back(), field.second.back());
  }
  PlotArea axes = field_axes(all, size);
  if (has_azimuth(all)) axes.x.ticks = angle_ticks(axes.x.range, 5);
  if (has_azimuth(all) && all.second_name == "height") axes.y.label = axis_label("height", all.second_unit);
  return axes;
}

Grid lay_out(std::size_t fields, double heading, const PlotArea& axes, double bar_width) {
  Grid grid;
  grid.columns = columns_for(fields);
  grid.rows = (fields + grid.columns - 1) / grid.columns;
  const double beside = left_margin(axes.y), columns = static_cast<double>(grid.columns);
  const double room = kWidth - 2 * kMargin - bar_width - kGap;
  grid.step_x = room / columns;
  grid.left = kMargin + beside;
  grid.top = kMargin + heading + kNameBand;
  grid.width = std::floor(grid.step_x - beside - (grid.columns > 1 ? kGap : 0));
  const double ratio = axes.x.range.length() > 0 ? axes.y.range.length() / axes.x.range.length() : 1;
  const bool equal_scales = axes.x.label.section(' ', -1) == axes.y.label.section(' ', -1);
  grid.height =
      std::round(std::clamp(equal_scales ? ratio * grid.width : 0.42 * grid.width, kLowest, kTallest));
  if (equal_scales) grid.width = std::min(grid.width, std::round(grid.height / ratio));
  grid.step_y = grid.height + kNameBand + bottom_margin() + 10;
  return grid;
}

/// What a panel says of seeds; nothing where all fields are means of as many, which the foot says.
QString seeds_of(const ComparedField& field, const std::vector<ComparedField>& fields) {
  const auto as_many = [&](const ComparedField& other) { return other.seeds == field.seeds; };
  if (field.seeds == 0 || (fields.size() > 1 && std::ranges::all_of(fields, as_many))) return {};
  return field.seeds == 1 ? QStringLiteral(", one seed")
                          : QStringLiteral(", mean of %1 seeds").arg(field.seeds);
}

/// The name and what is said of seeds, in smaller type where there is no room, and shortened in the middle
/// where that is not enough: names of variants differ at their beginnings or ends.
PanelName name_above(const QString& name, const QString& seeds, double width) {
  constexpr int kLeastPixels = 20;
  PanelName above{{}, kSubtitlePixels};
  const auto font = [&above] { return text_font(above.pixels, true); };
  while (above.pixels > kLeastPixels && text_width(name + seeds, font()) > width) --above.pixels;
  const QString shown =
      QFontMetricsF(font()).elidedText(name, Qt::ElideMiddle, width + 1 - text_width(seeds, font()));
  above.text = (shown + seeds).toStdString();
  return above;
}

void draw_name(QPainter& painter, const QRectF& rect, const PanelName& name) {
  painter.setFont(text_font(name.pixels, true));
  painter.setPen(Qt::black);
  painter.drawText(QRectF(rect.left(), rect.top() - kNameBand, rect.width(), kNameBand - 4),
                   Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, QString::fromStdString(name.text));
}

std::vector<double> all_values(const std::vector<ComparedField>& fields) {
  std::vector<double> values;
  for (const auto& [name, field, seeds] : fields)
    values.insert(values.end(), field.value.begin(), field.value.end());
  return values;
}

/// What of the field lies on the axes; beyond its own nodes there is no value.
PlacesShown paint_panel(QImage& image, const PlotArea& plot, const results::Field2D& field,
                        const ColourBar& bar) {
  PlotArea own = plot;
  const bool all_round = has_azimuth(field);  // the field comes round again: it has values from end to end
  const QPointF corner =
      plot.pixel(all_round ? plot.x.range.lower : field.first.front(), field.second.front());
  const QPointF opposite =
      plot.pixel(all_round ? plot.x.range.upper : field.first.back(), field.second.back());
  own.rect = QRectF(corner, opposite).normalized().intersected(plot.rect);
  own.x.range = {plot.value(own.rect.topLeft()).x(), plot.value(own.rect.bottomRight()).x()};
  own.y.range = {plot.value(own.rect.bottomRight()).y(), plot.value(own.rect.topLeft()).y()};
  const QColor grey(kNoValueColour.red, kNoValueColour.green, kNoValueColour.blue);
  QPainter(&image).fillRect(plot.rect, grey);
  PlacesShown places = paint_field(image, own, field, bar);
  if (own.rect != plot.rect) places.add(Place::kNoPowder);
  return places;
}

void draw_foot(QPainter& painter, double height, const std::vector<ComparedField>& fields,
               const PlacesShown& places, const ColourBar& bar) {
  const results::Field2D& field = fields.front().field;
  const std::size_t seeds = fields.front().seeds;
  const bool one_number =
      std::ranges::all_of(fields, [&](const ComparedField& one) { return one.seeds == seeds; });
  const QString means = !one_number || seeds == 0 ? QStringLiteral("Mean over seeds; ")
                        : fields.size() == 1      ? QString()
                        : seeds == 1              ? QStringLiteral("One seed each; ")
                                                  : QStringLiteral("Mean of %1 seeds each; ").arg(seeds);
  const double top = height - kMargin - 26;
  painter.setFont(text_font(kNotePixels));
  painter.setPen(QColor(70, 70, 70));
  QString note =
      means + QStringLiteral("Gaussian average, σ = %1 mm").arg(field.averaging_width * 1e3, 0, 'g', 3);
  if (has_azimuth(field)) note += QStringLiteral("; the shoe first arrives at 0° and leaves at 180°");
  if (!has_azimuth(field) && field.second_name == "y")
    note += QStringLiteral("; seen from above, mean over the height of the powder");
  painter.drawText(QRectF(kMargin, top, kWidth - 2 * kMargin, 32), Qt::AlignLeft | Qt::AlignVCenter, note);
  if (!places.any()) return;
  const bool own_line = places.several();
  const double left = own_line ? kMargin : kWidth - kMargin - places.legend_width();
  places.draw_legend(painter, {left, top + 2 - (own_line ? kLegendLine : 0)}, bar);
}

void draw_bar_beside(QPainter& painter, const ColourBar& bar, const Grid& grid) {
  const double height = std::min(grid.bottom() - grid.top, 900.0) - 2 * kBarPoint;
  const double left = kWidth - kMargin - colour_bar_width(bar);
  draw_colour_bar(painter, bar, {left, grid.top + kBarPoint, kBarWidth, height});
}

}  // namespace

ComparisonPicture compose_comparison(const std::vector<ComparedField>& fields, const std::string& title) {
  if (fields.empty()) throw std::runtime_error("cannot draw a comparison without fields");
  for (const auto& one : fields) check_field(one.field);
  constexpr double kFromData = std::numeric_limits<double>::quiet_NaN();
  ComparisonPicture picture;
  const auto values = all_values(fields);
  picture.bar =
      make_colour_bar(axis_label(fields.front().field.quantity, ""), values, {kFromData, kFromData});
  const Heading heading(title, "", kWidth - 2 * kMargin);
  PlotArea axes = common_axes(fields, {600, 260});
  const Grid grid = lay_out(fields.size(), heading.height(), axes, colour_bar_width(picture.bar));
  const double height = grid.bottom() + bottom_margin() + kFoot + kLegendLine + kMargin;
  picture.image = white_canvas(static_cast<int>(kWidth), static_cast<int>(height));
  PlacesShown places;
  std::vector<PanelName> names;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    picture.plots.push_back(axes);
    picture.plots.back().rect = grid.rect(k);
    names.push_back(name_above(QString::fromStdString(fields[k].name), seeds_of(fields[k], fields),
                               grid.room_for_name(k)));
    picture.names.push_back(names.back().text);
    places.add(paint_panel(picture.image, picture.plots.back(), fields[k].field, picture.bar));
  }
  QPainter painter(&picture.image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  heading.draw(painter, kMargin, kMargin - 8);
  for (std::size_t k = 0; k < fields.size(); ++k) {
    PlotArea plot = picture.plots[k];
    const bool lowest_in_column = k + grid.columns >= fields.size(), leftmost = k % grid.columns == 0;
    if (!lowest_in_column) plot.x.label.clear();
    if (!leftmost) plot.y.label.clear();
    draw_axes(painter, plot, picture.image.size());
    draw_name(painter, plot.rect, names[k]);
  }
  draw_bar_beside(painter, picture.bar, grid);
  draw_foot(painter, height, fields, places, picture.bar);
  return picture;
}

void draw_comparison(const std::filesystem::path& png, const std::vector<ComparedField>& fields,
                     const std::string& title) {
  write_png(png, compose_comparison(fields, title).image);
}

}  // namespace diefill::render
