#include "render/charts/legend_layout.h"

#include <QString>
#include <algorithm>
#include <cmath>
#include <utility>

namespace diefill::render {
namespace {

constexpr double kColumnGap = 40;

/// A curve and the width of its name.
struct NamedCurve {
  std::size_t curve;
  double width;
};

std::vector<NamedCurve> named(const std::vector<Curve>& curves, int pixels) {
  std::vector<NamedCurve> found;
  for (std::size_t k = 0; k < curves.size(); ++k)
    if (!curves[k].name.empty())
      found.push_back({k, text_width(QString::fromStdString(curves[k].name), text_font(pixels)) + 2});
  return found;
}

/// Row by row in `cells` cells of width `pitch`; a long name takes several.
LegendLayout in_cells(const std::vector<NamedCurve>& curves, std::size_t cells, double pitch, int pixels) {
  constexpr double kBesideName = kSampleLength + kTextGap + kColumnGap, kRounding = 1e-9;
  LegendLayout legend{{}, pixels};
  std::size_t cell = 0, row = 0;
  for (const NamedCurve& one : curves) {
    const double wanted = std::max(1.0, std::ceil((kBesideName + one.width) / pitch - kRounding));
    const std::size_t taken = std::min(cells, static_cast<std::size_t>(wanted));
    if (cell + taken > cells) {
      cell = 0;
      ++row;
    }
    legend.entries.push_back({one.curve, row, static_cast<double>(cell) * pitch,
                              std::min(one.width, static_cast<double>(taken) * pitch - kBesideName)});
    cell += taken;
  }
  return legend;
}

/// In columns as wide as the widest name asks for.
LegendLayout in_equal_columns(const std::vector<NamedCurve>& curves, double width, int pixels) {
  double pitch = 0;
  for (const NamedCurve& one : curves)
    pitch = std::max(pitch, kSampleLength + kTextGap + one.width + kColumnGap);
  pitch = std::min(pitch, width + kColumnGap);
  const double columns = pitch > 0 ? std::floor((width + kColumnGap) / pitch) : 1;
  return in_cells(curves, static_cast<std::size_t>(std::max(1.0, columns)), pitch, pixels);
}

/// In the cells that make the fewest rows.
LegendLayout in_fewest_rows(const std::vector<NamedCurve>& curves, double width, int pixels) {
  LegendLayout best = in_cells(curves, 1, width + kColumnGap, pixels);
  for (std::size_t cells = 2; cells <= curves.size(); ++cells) {
    LegendLayout other = in_cells(curves, cells, (width + kColumnGap) / static_cast<double>(cells), pixels);
    if (other.rows() < best.rows()) best = std::move(other);
  }
  return best;
}

}  // namespace

double LegendLayout::row_height() const {
  constexpr double kRow = 42;
  return kRow * pixels / kTickPixels;
}

LegendLayout legend_layout(const std::vector<Curve>& curves, double width) {
  constexpr std::size_t kFewRows = 3, kMostRows = 6;
  constexpr int kSmallType = 20;
  LegendLayout legend = in_equal_columns(named(curves, kTickPixels), width, kTickPixels);
  if (legend.rows() <= kFewRows) return legend;
  for (const int pixels : {kTickPixels, kNotePixels, kSmallType}) {
    legend = in_fewest_rows(named(curves, pixels), width, pixels);
    if (legend.rows() <= kMostRows) break;
  }
  return legend;
}

}  // namespace diefill::render
