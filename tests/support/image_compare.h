// Compares pictures as the eye does: small, in CIELAB, so that a shifted pixel or another smoothing of an
// edge passes and another colour, a missing curve or a moved label does not.
#pragma once

#include <QImage>
#include <algorithm>
#include <cmath>
#include <vector>

#include "render/style/colour_map.h"

namespace diefill::support {

/// How far two pictures are from each other, in CIELAB units (a difference of 2 is just noticed).
struct ImageDistance {
  double mean = 0;   ///< over the picture
  double worst = 0;  ///< that 99.5 % of the picture stay below
};

/// Width in pixels that pictures are compared at.
inline constexpr int kComparedWidth = 200;

/// A picture as it is stored for comparison: 400 pixels wide.
inline QImage as_reference(const QImage& image) {
  return image.scaledToWidth(400, Qt::SmoothTransformation).convertToFormat(QImage::Format_RGB32);
}

/// Distance of two pictures; of pictures of other proportions, infinite.
inline ImageDistance image_distance(const QImage& one, const QImage& other) {
  const auto small = [](const QImage& image) {
    return image.scaledToWidth(kComparedWidth, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_RGB32);
  };
  const QImage a = small(one), b = small(other);
  if (a.isNull() || std::abs(a.height() - b.height()) > 1) return {INFINITY, INFINITY};
  std::vector<double> distances;
  const auto lab = [](QRgb pixel) {
    return render::to_lab({static_cast<std::uint8_t>(qRed(pixel)), static_cast<std::uint8_t>(qGreen(pixel)),
                           static_cast<std::uint8_t>(qBlue(pixel))});
  };
  for (int row = 0; row < std::min(a.height(), b.height()); ++row)
    for (int column = 0; column < kComparedWidth; ++column) {
      const auto x = lab(a.pixel(column, row)), y = lab(b.pixel(column, row));
      distances.push_back(std::hypot(x.lightness - y.lightness, x.a - y.a, x.b - y.b));
    }
  ImageDistance distance;
  for (const double value : distances) distance.mean += value / static_cast<double>(distances.size());
  std::sort(distances.begin(), distances.end());
  distance.worst = distances[(distances.size() - 1) * 995 / 1000];
  return distance;
}

}  // namespace diefill::support
