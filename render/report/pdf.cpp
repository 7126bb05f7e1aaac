#include "render/report/pdf.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QGuiApplication>
#include <QPainter>
#include <QPdfWriter>
#include <QScreen>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextTable>
#include <QUrl>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace diefill::render::report {
namespace {

constexpr int kResolution = 300;  // dots an inch
constexpr double kFooter = 9 * kResolution / 25.4;
constexpr double kTextPoints = 8.5, kTablePoints = 7.5, kSmallPoints = 7;
constexpr double kLargestPicture = 105 * kResolution / 25.4;  // height

/// Formats of a text document count in dots of the screen that Qt imagines; layout turns them into the
/// page's.
double screen_dots_per_inch() {
  return QGuiApplication::primaryScreen()->logicalDotsPerInchY();
}

double millimetres(double length) {
  return length * screen_dots_per_inch() / 25.4;
}

QString text_of(const std::string& text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QFont font(double points, bool bold = false, const char* family = "DejaVu Sans") {
  QFont result(QString::fromLatin1(family));
  result.setPointSizeF(points);
  result.setBold(bold);
  return result;
}

QTextCharFormat letters(const QFont& with, const QColor& colour = QColor(28, 28, 28)) {
  QTextCharFormat format;
  format.setFont(with);
  format.setForeground(colour);
  return format;
}

QTextBlockFormat spacing(double above, double below) {
  QTextBlockFormat format;
  format.setTopMargin(millimetres(above));
  format.setBottomMargin(millimetres(below));
  return format;
}

/// Fills a text document block by block.
class Setter {
 public:
  Setter(QTextDocument& document, double width) : document_(document), cursor_(&document), width_(width) {}

  void heading(const std::string& text, double points, double above) {
    add_block(spacing(above, 1.5), letters(font(points, true), QColor(34, 64, 122)));
    cursor_.insertText(text_of(text));
    headings.push_back(cursor_.block().blockNumber());
  }

  void operator()(const Paragraph& paragraph) {
    QTextBlockFormat format = spacing(0.5, 1.5);
    if (paragraph.remark) format.setBackground(QColor(255, 246, 234));
    add_block(format, letters(font(kTextPoints)));
    cursor_.insertText(text_of(paragraph.text));
  }

  void operator()(const Table& table) {
    if (!table.caption.empty()) small(table.caption);
    const auto columns =
        table.header.empty() ? (table.rows.empty() ? 0 : table.rows.front().size()) : table.header.size();
    const std::size_t rows = table.rows.size() + (table.header.empty() ? 0 : 1);
    if (columns == 0 || rows == 0) return;
    QTextTable* grid = make_table(rows, columns, table);
    std::size_t row = 0;
    if (!table.header.empty()) fill_row(*grid, row++, table.header, true, table.numbers);
    for (const auto& cells : table.rows) fill_row(*grid, row++, cells, false, table.numbers);
    cursor_.movePosition(QTextCursor::End);
  }

  void operator()(const Figures& figures) {
    if (!figures.side_by_side || figures.figures.size() < 2) {
      for (const Figure& figure : figures.figures) {
        add_block(spacing(2, 0.5), {});
        insert_picture(cursor_, figure, width_);
        small(figure.caption);
      }
      return;
    }
    const std::size_t rows = (figures.figures.size() + 1) / 2;
    QTextTable* grid = make_table(rows, 2, {});
    for (std::size_t n = 0; n < figures.figures.size(); ++n) {
      QTextCursor cell = grid->cellAt(static_cast<int>(n / 2), static_cast<int>(n % 2)).firstCursorPosition();
      insert_picture(cell, figures.figures[n], 0.485 * width_);
      cell.insertBlock(spacing(0.5, 1.5), letters(font(kSmallPoints), QColor(70, 70, 70)));
      cell.insertText(text_of(figures.figures[n].caption));
    }
    cursor_.movePosition(QTextCursor::End);
  }

  // On paper nothing turns; the pictures of the run stand in sections of their own.
  void operator()(const View3D&) {
    (*this)(Paragraph{"The HTML page of this report has an interactive view here."});
  }
  void operator()(const Film&) { (*this)(Paragraph{"The HTML page of this report has a film here."}); }

  void operator()(const Listing& listing) {
    QTextBlockFormat format = spacing(0, 0);
    format.setBackground(QColor(245, 245, 245));
    for (const QString& line : text_of(listing.text).split(u'\n')) {
      add_block(format, letters(font(kSmallPoints, false, "DejaVu Sans Mono")));
      cursor_.insertText(line);
    }
  }

  std::vector<int> headings;  ///< numbers of their text blocks

 private:
  void add_block(const QTextBlockFormat& format, const QTextCharFormat& characters) {
    if (document_.isEmpty() && headings.empty()) {
      cursor_.setBlockFormat(format);
      cursor_.setCharFormat(characters);
    } else {
      cursor_.insertBlock(format, characters);
    }
  }

  void small(const std::string& text) {
    add_block(spacing(0.5, 1.5), letters(font(kSmallPoints), QColor(70, 70, 70)));
    cursor_.insertText(text_of(text));
  }

  QTextTable* make_table(std::size_t rows, std::size_t columns, const Table& table) {
    QTextTableFormat format;
    format.setBorder(0);
    format.setCellSpacing(0);
    format.setCellPadding(millimetres(0.8));
    format.setBottomMargin(millimetres(1.5));
    format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
    if (!table.header.empty()) format.setHeaderRowCount(1);
    if (!table.numbers && columns == 2 && !table.rows.empty())
      format.setColumnWidthConstraints(
          {QTextLength(QTextLength::PercentageLength, 42), QTextLength(QTextLength::PercentageLength, 58)});
    // Names of strategies are sentences; numbers need little room.
    if (table.numbers && columns > 3) {
      QList<QTextLength> widths(static_cast<qsizetype>(columns), QTextLength());
      widths[0] = QTextLength(QTextLength::PercentageLength, 34);
      format.setColumnWidthConstraints(widths);
    }
    cursor_.insertBlock(spacing(0, 0), letters(font(1)));
    return cursor_.insertTable(static_cast<int>(rows), static_cast<int>(columns), format);
  }

  static void fill_row(QTextTable& grid, std::size_t row, const std::vector<std::string>& cells, bool header,
                       bool numbers) {
    const int count = std::min(grid.columns(), static_cast<int>(cells.size()));
    for (int column = 0; column < count; ++column) {
      QTextTableCell cell = grid.cellAt(static_cast<int>(row), column);
      QTextTableCellFormat format;
      format.setBottomBorder(header ? 0.8 : 0.4);
      format.setBottomBorderStyle(QTextFrameFormat::BorderStyle_Solid);
      format.setBottomBorderBrush(header ? QColor(110, 110, 110) : QColor(200, 200, 200));
      cell.setFormat(format);
      QTextCursor cursor = cell.firstCursorPosition();
      QTextBlockFormat block;
      block.setAlignment(numbers && column > 0 ? Qt::AlignRight : Qt::AlignLeft);
      cursor.setBlockFormat(block);
      cursor.insertText(text_of(cells[static_cast<std::size_t>(column)]),
                        letters(font(kTablePoints, header)));
    }
  }

  void insert_picture(QTextCursor& cursor, const Figure& figure, double most_width) {
    const QImage image = QImage::fromData(figure.png, "PNG");
    if (image.isNull()) throw std::runtime_error("cannot read a picture of the report");
    const QString name = QStringLiteral("picture-%1").arg(pictures_++);
    document_.addResource(QTextDocument::ImageResource, QUrl(name), image);
    const double scale = std::min(most_width / image.width(), kLargestPicture / image.height());
    QTextImageFormat format;
    format.setName(name);
    const double on_screen = scale * screen_dots_per_inch() / kResolution;
    format.setWidth(image.width() * on_screen);
    format.setHeight(image.height() * on_screen);
    cursor.insertImage(format);
  }

  QTextDocument& document_;
  QTextCursor cursor_;
  double width_;
  int pictures_ = 0;
};

/// Page on which a text block begins.
int page_of(const QTextDocument& document, const QTextBlock& block) {
  double top = document.documentLayout()->blockBoundingRect(block).top();
  // A picture that does not fit moves to the next page while its block's rectangle begins on this one.
  if (block.layout()->lineCount() > 0) top += block.layout()->lineAt(0).y();
  return static_cast<int>(top / document.pageSize().height());
}

/// Whether what follows a heading begins on another page, or will once it is drawn: where a picture does not
/// fit below the heading.
bool stands_alone(const QTextDocument& document, const QTextBlock& heading, const QTextBlock& next) {
  if (page_of(document, next) != page_of(document, heading)) return true;
  if (next.layout()->lineCount() == 0) return false;
  const double page = document.pageSize().height();
  const QRectF place = document.documentLayout()->blockBoundingRect(heading);
  const double below = std::fmod(place.top(), page) + place.height() + next.layout()->lineAt(0).height();
  return below > page;
}

/// Begins a page with every heading that would stand alone at the foot of one.
void keep_headings(QTextDocument& document, const std::vector<int>& headings) {
  for (const int number : headings) {
    const QTextBlock heading = document.findBlockByNumber(number);
    QTextBlock next = heading.next();
    if (next.isValid() && next.text().isEmpty() && next.next().isValid()) next = next.next();
    if (!next.isValid() || !stands_alone(document, heading, next)) continue;
    QTextCursor cursor(heading);
    QTextBlockFormat format = heading.blockFormat();
    format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
    cursor.setBlockFormat(format);
  }
}

void draw_pages(QPdfWriter& writer, QTextDocument& document, const std::string& title) {
  QPainter painter(&writer);
  if (!painter.isActive()) throw std::runtime_error("Qt cannot write the PDF");
  const double width = document.pageSize().width(), height = document.pageSize().height();
  const int pages = document.pageCount();
  for (int page = 0; page < pages; ++page) {
    if (page > 0) writer.newPage();
    painter.save();
    painter.translate(0, -page * height);
    document.drawContents(&painter, QRectF(0, page * height, width, height));
    painter.restore();
    painter.setFont(font(kSmallPoints));
    painter.setPen(QColor(90, 90, 90));
    const QRectF foot(0, height + 0.4 * kFooter, width, 0.6 * kFooter);
    const QString left =
        painter.fontMetrics().elidedText(text_of(title), Qt::ElideRight, static_cast<int>(0.8 * width));
    painter.drawText(foot, Qt::AlignLeft | Qt::AlignBottom, left);
    painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom,
                     QStringLiteral("%1 / %2").arg(page + 1).arg(pages));
  }
}

}  // namespace

std::string pdf_pages(const Document& document) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setResolution(kResolution);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(18, 16, 18, 12), QPageLayout::Millimeter);
    writer.setTitle(text_of(document.title));
    writer.setCreator(QStringLiteral("diefill"));
    QTextDocument text;
    text.setDocumentMargin(0);
    text.documentLayout()->setPaintDevice(&writer);
    text.setPageSize(QSizeF(writer.width(), writer.height() - kFooter));
    Setter setter(text, writer.width());
    setter.heading(document.title, 17, 0);
    setter(Paragraph{document.subtitle});
    for (const Section& section : document.sections) {
      setter.heading(section.title, section.level == 1 ? 12.5 : 10, section.level == 1 ? 6 : 4);
      for (const Block& block : section.blocks) std::visit(setter, block);
    }
    keep_headings(text, setter.headings);
    draw_pages(writer, text, document.title);
  }
  return bytes.toStdString();
}

}  // namespace diefill::render::report
