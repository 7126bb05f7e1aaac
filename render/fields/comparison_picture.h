// Density maps of several filling strategies side by side, on one colour scale.
#pragma once

#include <QImage>
#include <filesystem>
#include <string>
#include <vector>

#include "process/results/fill_result.h"
#include "render/style/axes.h"
#include "render/style/colour_bar.h"

namespace diefill::render {

/// The field of one filling strategy.
struct ComparedField {
  std::string name;
  results::Field2D field;
  std::size_t seeds = 0;  ///< that it is the mean of; 0: not said
};

/// A finished picture, with the geometry needed to read values from it.
struct ComparisonPicture {
  QImage image;
  std::vector<PlotArea> plots;     ///< one for each field
  std::vector<std::string> names;  ///< what stands above each
  ColourBar bar;
};

/// Lays out and draws the fields in rows, in their order: the same axes and the same colours for all, so that
/// equal colours are equal solid fractions and equal heights stand level. Throws std::runtime_error for no
/// fields, or one whose coordinates do not match its values.
ComparisonPicture compose_comparison(const std::vector<ComparedField>& fields, const std::string& title);

/// The same as a PNG. Throws as write_png() does too.
void draw_comparison(const std::filesystem::path& png, const std::vector<ComparedField>& fields,
                     const std::string& title);

}  // namespace diefill::render
