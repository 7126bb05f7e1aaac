// Where the entries of a chart's legend go.
#pragma once

#include <cstddef>
#include <vector>

#include "render/charts/chart.h"
#include "render/style/text.h"

namespace diefill::render {

/// Pixels: of the piece of curve before a name, and from it to the name.
inline constexpr double kSampleLength = 64, kTextGap = 12;

/// The sample of a curve and its name.
struct LegendItem {
  std::size_t curve, row;
  double left, room;  ///< from the legend's left; for the name
};

struct LegendLayout {
  std::vector<LegendItem> entries;
  int pixels = kTickPixels;  ///< of the type

  std::size_t rows() const { return entries.empty() ? 0 : entries.back().row + 1; }
  double row_height() const;
};

/// Names of the curves in columns within `width`. Many names stand closer, then in smaller type, so that the
/// legend does not outgrow the curves.
LegendLayout legend_layout(const std::vector<Curve>& curves, double width);

}  // namespace diefill::render
