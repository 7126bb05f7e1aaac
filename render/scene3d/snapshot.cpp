#include "render/scene3d/snapshot.h"

#include <QFontMetricsF>
#include <QTextOption>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "render/fields/pictures.h"
#include "render/scene3d/grain_view.h"
#include "render/style/picture_file.h"
#include "render/style/text.h"

namespace diefill::render {
namespace {

constexpr int kWidth = 1600, kHeight = 1200;
constexpr double kMargin = 36;
constexpr double kFoot = 92;  // scale bar, legend and axes below the scene
constexpr double kBarColumn = 220;

bool is_closed(const results::GrainSolidFraction& fraction, std::size_t grain) {
  return grain < fraction.solid_fraction.size() && grain < fraction.open.size() && !fraction.open[grain] &&
         std::isfinite(fraction.solid_fraction[grain]);
}

// A round length that takes about a sixth of the view, mm.
double scale_bar_length(double view_width_mm) {
  const double most = view_width_mm / 5;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= most) return factor * power;
  return power;
}

void draw_scale_bar(QPainter& painter, const SnapshotPicture& picture, double middle) {
  const double left = picture.scene.left(), end = 9;
  const double right = left + picture.scale_pixels;
  painter.setPen(QPen(Qt::black, 4, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(QPointF(left, middle), QPointF(right, middle));
  for (const double x : {left + 2, right - 2})
    painter.drawLine(QPointF(x, middle - end), QPointF(x, middle + end));
  painter.setFont(text_font(kTickPixels));
  painter.drawText(QRectF(right + 16, middle - 30, 260, 60), Qt::AlignLeft | Qt::AlignVCenter,
                   QStringLiteral("%1 mm").arg(picture.scale_bar));
}

void draw_arrow(QPainter& painter, const QPointF& from, const QPointF& to, const QString& name,
                const QPointF& at) {
  constexpr double kHead = 11;
  const QPointF along = (to - from) / std::hypot(to.x() - from.x(), to.y() - from.y());
  const QPointF across(-along.y(), along.x());
  painter.setPen(QPen(Qt::black, 3));
  painter.drawLine(from, to - 0.8 * kHead * along);
  painter.setBrush(Qt::black);
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(
      QPolygonF({to, to - kHead * along + 0.5 * kHead * across, to - kHead * along - 0.5 * kHead * across}));
  painter.setPen(Qt::black);
  painter.setFont(text_font(kNotePixels));
  painter.drawText(QRectF(at.x() - 20, at.y() - 20, 40, 40), Qt::AlignCenter, name);
}

// The axes as a turned eye sees them; one that points at the eye is left out.
void draw_turned_triad(QPainter& painter, const QPointF& origin, const ViewChoice& view) {
  constexpr double kLength = 52, kMin = 12;
  const ViewAxes axes = view_axes(view);
  const std::array<QString, 3> names = {"x", "y", "z"};
  for (int n = 0; n < 3; ++n) {
    const QPointF arrow(kLength * axes.right[n], -kLength * axes.up[n]);
    const double length = std::hypot(arrow.x(), arrow.y());
    if (length > kMin)
      draw_arrow(painter, origin, origin + arrow, names[n], origin + arrow * (1 + 18 / length));
  }
}

// The three axes as the tilted view shows them: y points into the picture, and so upwards by the tilt's sine.
void draw_triad(QPainter& painter, const QPointF& origin, const ViewChoice& view) {
  constexpr double kLength = 52;
  const double elevation = view.elevation;
  if (view.azimuth != 0 || elevation > 1.2) {
    draw_turned_triad(painter, origin - QPointF(0, 40), view);
    return;
  }
  const QPointF x(kLength, 0), z(0, -kLength * std::cos(elevation));
  const QPointF y(0.0, -kLength * std::sin(elevation));
  // Seen exactly from the front y would lie on z: a slant, as on drawings, keeps them apart.
  const QPointF slanted = y + QPointF(0.5 * kLength, 0);
  draw_arrow(painter, origin, origin + x, QStringLiteral("x"), origin + x + QPointF(16, 0));
  draw_arrow(painter, origin, origin + z, QStringLiteral("z"), origin + z + QPointF(0, -16));
  draw_arrow(painter, origin, origin + slanted, QStringLiteral("y"), origin + slanted + QPointF(16, -6));
}

void draw_foot(QPainter& painter, const SnapshotPicture& picture, const QString& grey_means) {
  const double middle = picture.scene.bottom() + 0.5 * kFoot + 8;
  if (picture.view.empty) return;
  draw_scale_bar(painter, picture, middle);
  draw_triad(painter, {kWidth - kMargin - 110, middle + 34}, picture.view);
  if (grey_means.isEmpty()) return;
  const QColor grey(kNoValueColour.red, kNoValueColour.green, kNoValueColour.blue);
  draw_swatch(painter, {picture.scene.left() + 0.36 * picture.scene.width(), middle - 14}, grey, grey_means);
}

/// s in milliseconds' digits; shorter times, of the wire's groove, in microseconds.
QString time_text(double time) {
  constexpr double kMilli = 1e-3, kMicro = 1e-6;
  if (time <= 0 || time >= kMilli) return QStringLiteral("t = %1 s").arg(time, 0, 'f', 3);
  return QStringLiteral("t = %1 µs").arg(time / kMicro, 0, 'g', 3);
}

std::string subtitle_of(const results::FillResult& result) {
  std::string text = result.powder_name;
  const auto add = [&text](const QString& part) { text += (text.empty() ? "" : ", ") + part.toStdString(); };
  if (result.powder.grain_diameter > 0)
    add(QStringLiteral("grain size ") + QString::fromStdString(result.powder.sizes_text()));
  if (!result.powder.position.empty()) add(QStringLiteral("%1 grains").arg(result.powder.position.size()));
  add(time_text(result.powder.time));
  return text;
}

Heading heading_of(const results::FillResult& result) {
  return {result.strategy.empty() ? result.title : result.strategy, subtitle_of(result),
          kWidth - 2 * kMargin};
}

QRectF scene_rect(const Heading& heading, bool has_bar) {
  const double top = std::round(kMargin + heading.height() + 12),
               right = kWidth - kMargin - (has_bar ? kBarColumn : 0);
  return {QPointF(kMargin, top), QPointF(right, kHeight - kFoot - kMargin / 2)};
}

/// The grains and tools in their frame, and the scale bar's length.
void draw_scene(QPainter& painter, SnapshotPicture& picture, const results::FillResult& result,
                const std::vector<double>& values, const ViewOptions& options) {
  std::vector<Rgb> colours;
  for (const double value : values)
    colours.push_back(value_colour(value, picture.bar.range.lower, picture.bar.range.upper));
  const QSize size = (picture.scene.toRect().size().toSizeF() * options.pixels).toSize();
  painter.drawImage(QRectF(picture.scene.topLeft(), picture.scene.toRect().size()),
                    draw_grains(result, colours, picture.view, size.width(), size.height(), options.look));
  painter.setPen(QPen(QColor(150, 150, 150), 1.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(picture.scene);
  picture.scale_bar = scale_bar_length(1e3 * picture.view.width);
  picture.scale_pixels = picture.scale_bar / (1e3 * picture.view.width) * picture.scene.width();
}

/// A swatch for each kind, one below the other, with its name in as many lines as it takes.
void draw_kinds_beside(QPainter& painter, SnapshotPicture& picture, const std::vector<std::string>& kinds) {
  constexpr double kSide = 28, kApart = 18;
  const double left = picture.scene.right() + 24, text_left = left + kSide + 10;
  double top = picture.scene.top() + 24;
  painter.setFont(text_font(kNotePixels));
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    picture.swatches.emplace_back(left, top, kSide, kSide);
    const Rgb colour = bar_colour(picture.bar, static_cast<double>(k + 1));
    painter.setPen(QPen(Qt::black, 1.5));
    painter.setBrush(QColor(colour.red, colour.green, colour.blue));
    painter.drawRect(picture.swatches.back());
    const QRectF room(text_left, top - 2, kWidth - kMargin / 2 - text_left, picture.scene.bottom() - top);
    QTextOption words(Qt::AlignLeft | Qt::AlignTop);
    words.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    painter.setPen(Qt::black);
    const QString name = QString::fromStdString(kinds[k]);
    painter.drawText(room, name, words);
    const QRectF taken = QFontMetricsF(painter.font()).boundingRect(room, Qt::TextWrapAnywhere, name);
    top += std::max(kSide, taken.height()) + kApart;
  }
}

void draw_bar_beside(QPainter& painter, SnapshotPicture& picture) {
  const double height = std::min(760.0, picture.scene.height() - 2 * kBarPoint);
  picture.bar_rect = QRectF(picture.scene.right() + 44, std::round(picture.scene.center().y() - 0.5 * height),
                            kBarWidth, std::round(height));
  draw_colour_bar(painter, picture.bar, picture.bar_rect);
}

}  // namespace

std::vector<double> fractions_of_closed_cells(const results::FillResult& result) {
  std::vector<double> values(result.powder.position.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < values.size(); ++k)
    if (is_closed(result.solid_fraction, k)) values[k] = result.solid_fraction.solid_fraction[k];
  return values;
}

SnapshotPicture compose_snapshot(const results::FillResult& result, const ViewOptions& options) {
  const std::vector<double> values =
      options.values.empty() ? fractions_of_closed_cells(result) : options.values;
  const auto closed = static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double value) { return std::isfinite(value); }));
  SnapshotPicture picture;
  picture.image = white_canvas(kWidth, kHeight, options.pixels);
  const Interval range = options.kinds.size() < 2 ? Interval{options.lower, options.upper}
                                                  : Interval{1, static_cast<double>(options.kinds.size())};
  picture.bar = make_colour_bar(axis_label(options.quantity, options.unit), values, range);
  QPainter painter(&picture.image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  const Heading heading = heading_of(result);
  heading.draw(painter, kMargin, kMargin - 8);
  picture.scene = scene_rect(heading, closed > 0);
  picture.view = options.view
                     ? *options.view
                     : choose_view(result, picture.scene.width() / picture.scene.height(), options.camera);
  if (picture.view.empty) {
    draw_centred(painter, picture.scene.center(), QStringLiteral("no powder or tools to show"), kLabelPixels,
                 picture.scene.width());
    return picture;
  }
  draw_scene(painter, picture, result, values, options);
  draw_foot(painter, picture,
            closed < values.size() ? QString::fromStdString(options.grey_means) : QString());
  if (!options.kinds.empty())
    draw_kinds_beside(painter, picture, options.kinds);
  else if (closed > 0)
    draw_bar_beside(painter, picture);
  return picture;
}

double scene_aspect(const results::FillResult& result) {
  const QRectF scene = scene_rect(heading_of(result), true);
  return scene.width() / scene.height();
}

void draw_snapshot(const std::filesystem::path& png, const results::FillResult& result,
                   const ColourRange& range) {
  ViewOptions options;
  options.lower = range.lower;
  options.upper = range.upper;
  write_png(png, compose_snapshot(result, options).image);
}

}  // namespace diefill::render
