#include "render/style/picture_bytes.h"

#include <QBuffer>
#include <QPainter>
#include <stdexcept>

namespace diefill::render {

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
