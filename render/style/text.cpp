#include "render/style/text.h"

#include <QFontMetricsF>
#include <QTextLayout>
#include <algorithm>
#include <regex>

namespace diefill::render {
namespace {

constexpr int kMaxLines = 2;
const QColor kSubtitleColour(70, 70, 70);

int line_count(const QString& text, const QFont& font, double width) {
  QTextLayout layout(text, font);
  QTextOption option;
  option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  layout.setTextOption(option);
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine())
    line.setLineWidth(width);
  layout.endLayout();
  return layout.lineCount();
}

// Drops characters from the end, and puts an ellipsis, until the text fits.
QString shorten(QString text, const QFont& font, double width) {
  while (text.size() > 1 && line_count(text + QChar(0x2026), font, width) > kMaxLines) text.chop(1);
  return text.trimmed() + QChar(0x2026);
}

/// Whether a key of scenes is named, such as powder.friction, which is spelt as there.
bool names_key(const std::string& text) {
  const std::regex key("[A-Za-z][._][A-Za-z]");
  return std::regex_search(text, key);
}

}  // namespace

QFont text_font(int pixels, bool bold) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(pixels);
  font.setBold(bold);
  font.setStyleHint(QFont::SansSerif);
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

double text_width(const QString& text, const QFont& font) {
  return QFontMetricsF(font).horizontalAdvance(text);
}

Heading::Heading(const std::string& title, const std::string& subtitle, double width)
    : width_(width),
      title_(fit(title, kTitlePixels, 26, true, width)),
      subtitle_(fit(subtitle, kSubtitlePixels, 22, false, width)) {}

Heading::Block Heading::fit(const std::string& text, int pixels, int least_pixels, bool bold, double width) {
  Block block{QString::fromStdString(text).simplified(), text_font(pixels, bold), 0};
  if (block.text.isEmpty()) return block;
  // A little shrinking may save a line; after that two lines are better than small print.
  for (int size = pixels; size >= pixels - 6 && line_count(block.text, block.font, width) > 1; --size)
    block.font = text_font(size, bold);
  if (line_count(block.text, block.font, width) > 1) {
    int size = pixels;
    for (block.font = text_font(size, bold);
         size > least_pixels && line_count(block.text, block.font, width) > kMaxLines;)
      block.font = text_font(--size, bold);
  }
  if (line_count(block.text, block.font, width) > kMaxLines)
    block.text = shorten(block.text, block.font, width);
  block.height = line_count(block.text, block.font, width) * QFontMetricsF(block.font).lineSpacing() + 4;
  return block;
}

void Heading::draw(QPainter& painter, double left, double top) const {
  for (const Block* block : {&title_, &subtitle_}) {
    if (block->text.isEmpty()) continue;
    QTextOption option(Qt::AlignLeft | Qt::AlignTop);
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    painter.setFont(block->font);
    painter.setPen(block == &title_ ? QColor(Qt::black) : kSubtitleColour);
    painter.drawText(QRectF(left, top, width_, block->height + 8), block->text, option);
    top += block->height;
  }
}

int fitting_pixels(const QString& text, int pixels, double most_width) {
  constexpr int kLeast = 16;
  while (pixels > kLeast && text_width(text, text_font(pixels)) > most_width) --pixels;
  return pixels;
}

void draw_centred(QPainter& painter, const QPointF& centre, const QString& text, int pixels,
                  double most_width, double angle) {
  constexpr double kRounding = 1;  // pixels
  pixels = fitting_pixels(text, pixels, most_width);
  const QFont font = text_font(pixels);
  const QString shown = QFontMetricsF(font).elidedText(text, Qt::ElideRight, most_width + kRounding);
  painter.save();
  painter.translate(centre);
  painter.rotate(angle);
  painter.setFont(font);
  painter.setPen(Qt::black);
  const double half = 0.5 * most_width + 4;
  painter.drawText(QRectF(-half, -2.0 * pixels, 2 * half, 4.0 * pixels), Qt::AlignCenter, shown);
  painter.restore();
}

QString axis_label(const std::string& name, const std::string& unit) {
  QString text = QString::fromStdString(name);
  if (text.size() > 1 && !names_key(name)) text[0] = text[0].toUpper();
  QString written = QString::fromStdString(unit);
  if (unit.empty() || unit == "1" || unit == "-") written = QStringLiteral("–");
  if (unit == "deg" || unit == "degree" || unit == "degrees") written = QStringLiteral("°");
  return QStringLiteral("%1 [%2]").arg(text, written);
}

}  // namespace diefill::render
