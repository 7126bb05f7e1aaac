// Pictures on disk: a PNG is written whole or not at all.
#pragma once

#include <QImage>
#include <QPainter>
#include <filesystem>
#include <functional>

namespace diefill::render {

/// A white canvas of the given size in layout points, marked for printing at 100 points a centimetre. With
/// `pixels` 2 it has twice as many pixels each way for the same print. Throws std::invalid_argument below 1,
/// which Qt does not scale to.
QImage white_canvas(int width, int height, double pixels = 1);

/// Writes a PDF of one page, `size` layout points large, that `paint` draws. Whole or not at all, as below.
void write_pdf_page(const std::filesystem::path& pdf, const QSizeF& size,
                    const std::function<void(QPainter&)>& paint);

/// Writes `image` as a PNG. Throws std::runtime_error (one line, naming the file) when it cannot be written;
/// what was there before then still stands.
void write_png(const std::filesystem::path& png, const QImage& image);

/// The same scaled to exactly `width` pixels for a print of the same size.
void write_png(const std::filesystem::path& png, const QImage& image, int width);

}  // namespace diefill::render
