#include "render/picture_file.h"

#include <stdexcept>

#include "process/results/atomic_file.h"

namespace diefill::render {

QImage white_canvas(int width, int height) {
  QImage canvas(width, height, QImage::Format_RGB32);
  canvas.setDotsPerMeterX(10000);
  canvas.setDotsPerMeterY(10000);
  canvas.fill(Qt::white);
  return canvas;
}

void write_png(const std::filesystem::path& png, const QImage& image) {
  results::write_atomically(png, [&](const std::filesystem::path& temporary) {
    if (!image.save(QString::fromStdString(temporary.string()), "PNG"))
      throw std::runtime_error("the picture could not be stored");
  });
}

}  // namespace diefill::render
