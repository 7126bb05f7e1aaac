// Cost against error: every setting's cost and error, the Pareto front, the recommended setting, the scatter
// over seeds below which an error has no meaning, and settings that fail in a quantity that scatters less.
// One small chart per parameter.
#pragma once

#include <QImage>
#include <filesystem>
#include <vector>

#include "process/results/studies/tradeoff.h"
#include "render/style/axes.h"

namespace diefill::render {

/// A finished chart, with what is needed to find its points and labels.
struct TradeoffPicture {
  QImage image;
  PlotArea plot;
  std::vector<std::size_t> points;  ///< of Tradeoff::points that are drawn
  std::vector<QPointF> places;      ///< of their marks
  std::vector<QRectF> labels;       ///< one for all points whose marks lie on top of each other
};

/// Error (percent, logarithmic) over processor time of a run (core seconds, logarithmic). Errors far below
/// the floor, and those of nothing, stand at the lower edge. Throws std::runtime_error where no setting has a
/// cost and an error.
TradeoffPicture compose_tradeoff(const results::Tradeoff& tradeoff);
/// The same as a PNG; throws as write_png() does too.
void draw_tradeoff(const std::filesystem::path& png, const results::Tradeoff& tradeoff);

/// A finished chart of a parameter: deviations above, costs below.
struct ParameterPicture {
  QImage image;
  PlotArea deviation, cost;
};

/// What one parameter does: deviation of every deciding quantity from the base (percent, with its scatter
/// over seeds) and the processor time of a run, over the parameter's values from coarse to fine.
ParameterPicture compose_parameter(const results::Tradeoff& tradeoff, const results::ParameterRow& parameter);
void draw_parameter(const std::filesystem::path& png, const results::Tradeoff& tradeoff,
                    const results::ParameterRow& parameter);

}  // namespace diefill::render
