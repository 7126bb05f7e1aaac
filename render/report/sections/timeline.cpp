#include "render/report/sections/timeline.h"

#include <QPainter>
#include <algorithm>
#include <stdexcept>

#include "render/style/axes.h"
#include "render/style/picture_file.h"
#include "render/style/text.h"
#include "render/style/ticks.h"

namespace diefill::render::report {
namespace {

constexpr double kWidth = 1600, kMargin = 36, kRow = 66, kBar = 34;
const QColor kMoving(59, 82, 139), kResting(190, 196, 204);

QString label_of(const results::Stage& stage) {
  QString text = QString::fromStdString(stage.words);
  if (!stage.tool.empty()) text += QStringLiteral(" (%1)").arg(QString::fromStdString(stage.tool));
  return text;
}

double label_width(const std::vector<results::Stage>& stages) {
  double width = 0;
  for (const auto& stage : stages)
    width = std::max(width, text_width(label_of(stage), text_font(kTickPixels)));
  return std::min(width, 0.42 * kWidth);
}

void draw_stage(QPainter& painter, const results::Stage& stage, const PlotArea& area, double top) {
  const double left = area.pixel(stage.start, 0).x(), right = area.pixel(stage.end, 0).x();
  const QRectF row(kMargin, top, area.rect.left() - kMargin - 18, kRow);
  painter.setFont(text_font(kTickPixels));
  painter.setPen(Qt::black);
  const QString label =
      painter.fontMetrics().elidedText(label_of(stage), Qt::ElideRight, static_cast<int>(row.width()));
  painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, label);
  const QRectF bar(left, top + 0.5 * (kRow - kBar), std::max(3.0, right - left), kBar);
  painter.fillRect(bar, stage.tool.empty() ? kResting : kMoving);
  const QString time = QStringLiteral("%1 s").arg(stage.end - stage.start, 0, 'g', 3);
  const double width = text_width(time, text_font(kNotePixels));
  painter.setFont(text_font(kNotePixels));
  QRectF place(bar.right() + 8, top, width + 4, kRow);
  const bool inside = bar.width() > width + 16;
  if (inside) place.moveRight(bar.right() - 6);
  if (!inside && place.right() > area.rect.right()) place.moveRight(bar.left() - 8);
  painter.setPen(inside && !stage.tool.empty() ? Qt::white : Qt::black);
  painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, time);
}

}  // namespace

QImage compose_timeline(const std::vector<results::Stage>& stages) {
  if (stages.empty()) throw std::invalid_argument("a timeline needs stages");
  PlotArea area;
  const double left = kMargin + label_width(stages) + 20;
  const double height = kRow * static_cast<double>(stages.size()) + 12;
  area.rect = QRectF(left, kMargin, kWidth - left - 2 * kMargin, height);
  area.x.label = axis_label("time", "s");
  area.x.range = {0, std::max(stages.back().end, 1e-9)};
  area.x.ticks = nice_ticks(area.x.range, 8);
  area.y.range = {0, 1};
  const QSizeF canvas(kWidth, std::round(kMargin + height + bottom_margin() + kMargin));
  QImage image = white_canvas(static_cast<int>(canvas.width()), static_cast<int>(canvas.height()));
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  draw_grid(painter, area);
  for (std::size_t n = 0; n < stages.size(); ++n)
    draw_stage(painter, stages[n], area, kMargin + 6 + kRow * static_cast<double>(n));
  draw_axes(painter, area, canvas);
  return image;
}

}  // namespace diefill::render::report
