#include "render/style/picture_file.h"

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

}  // namespace diefill::render
