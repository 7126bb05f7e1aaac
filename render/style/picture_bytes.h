// Pictures in memory: as the bytes of a file, and several in one.
#pragma once

#include <QByteArray>
#include <QImage>
#include <vector>

namespace diefill::render {

/// The picture as the bytes of a PNG file, scaled to `width` pixels unless that is 0. Throws
/// std::runtime_error where Qt cannot write it.
QByteArray png_bytes(const QImage& image, int width = 0);

/// Pictures of one size in one: two side by side, more in rows of two.
QImage side_by_side(const std::vector<QImage>& pictures);

}  // namespace diefill::render
