#include "render/style/picture_file.h"

#include <QBuffer>
#include <QPageSize>
#include <QPdfWriter>
#include <cmath>
#include <stdexcept>

#include "process/results/storage/atomic_file.h"

namespace diefill::render {

QImage white_canvas(int width, int height, double pixels) {
  if (!(pixels >= 1)) throw std::invalid_argument("pictures need at least one pixel per layout point");
  QImage canvas(static_cast<int>(std::lround(width * pixels)), static_cast<int>(std::lround(height * pixels)),
                QImage::Format_RGB32);
  canvas.setDevicePixelRatio(pixels);
  canvas.setDotsPerMeterX(static_cast<int>(std::lround(10000 * pixels)));
  canvas.setDotsPerMeterY(static_cast<int>(std::lround(10000 * pixels)));
  canvas.fill(Qt::white);
  return canvas;
}

void write_pdf_page(const std::filesystem::path& pdf, const QSizeF& size,
                    const std::function<void(QPainter&)>& paint) {
  constexpr double kMillimetresAPoint = 0.1;
  results::write_atomically(pdf, [&](const std::filesystem::path& temporary) {
    QPdfWriter writer(QString::fromStdString(temporary.string()));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setPageSize(QPageSize(size * kMillimetresAPoint, QPageSize::Millimeter));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setResolution(1200);
    writer.setTitle(QStringLiteral("diefill"));
    QPainter painter;
    if (!painter.begin(&writer)) throw std::runtime_error("cannot write the page");
    const double scale = writer.width() / size.width();
    painter.scale(scale, scale);
    paint(painter);
    if (!painter.end()) throw std::runtime_error("cannot write the page");
  });
}

void write_png(const std::filesystem::path& png, const QImage& image) {
  results::write_atomically(png, [&](const std::filesystem::path& temporary) {
    if (!image.save(QString::fromStdString(temporary.string()), "PNG"))
      throw std::runtime_error("cannot write the picture");
  });
}

void write_png(const std::filesystem::path& png, const QImage& image, int width) {
  QImage exact = image.width() == width ? image : image.scaledToWidth(width, Qt::SmoothTransformation);
  const double print = image.dotsPerMeterX() * static_cast<double>(width) / image.width();
  exact.setDotsPerMeterX(static_cast<int>(std::lround(print)));
  exact.setDotsPerMeterY(static_cast<int>(std::lround(print)));
  write_png(png, exact);
}

QByteArray png_bytes(const QImage& image, int width) {
  const QImage sized = width > 0 ? image.scaledToWidth(width, Qt::SmoothTransformation) : image;
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!sized.save(&buffer, "PNG")) throw std::runtime_error("cannot write a picture as PNG");
  return bytes;
}

QImage side_by_side(const std::vector<QImage>& pictures) {
  const int width = pictures.front().width(), height = pictures.front().height();
  const int columns = pictures.size() > 1 ? 2 : 1,
            rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  QImage whole(columns * width, rows * height, QImage::Format_RGB32);
  whole.fill(Qt::white);
  QPainter painter(&whole);
  for (int k = 0; k < static_cast<int>(pictures.size()); ++k)
    painter.drawImage(QRect(k % columns * width, k / columns * height, width, height),
                      pictures[static_cast<std::size_t>(k)]);
  return whole;
}

}  // namespace diefill::render
