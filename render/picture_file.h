// Pictures on disk: a PNG is written whole or not at all.
#pragma once

#include <QImage>
#include <filesystem>

namespace diefill::render {

/// A white canvas of the given size, marked for printing at 254 dots an inch (100 pixels a centimetre).
QImage white_canvas(int width, int height);

/// Writes `image` as a PNG. Throws std::runtime_error (one line, naming the file) when it cannot be written;
/// what was there before then still stands.
void write_png(const std::filesystem::path& png, const QImage& image);

}  // namespace diefill::render
