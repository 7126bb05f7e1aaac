// The marks of settings in a chart of cost against error, and the legend that explains them.
#pragma once

#include <QColor>
#include <QPainter>

#include "process/results/studies/tradeoff.h"

namespace diefill::render {

/// Pixels.
inline constexpr double kMarkRadius = 11, kStarRadius = 24;

/// Of errors below the scatter over seeds, the Pareto front, the recommended setting.
QColor floor_colour();
QColor front_colour();
QColor chosen_colour();

/// Some runs of the setting are finished and some have failed.
bool failed_with_a_seed(const results::TradeoffPoint& point);

/// Pixels that the mark of a setting takes round its middle.
double mark_radius(const results::TradeoffPoint& point);

void draw_mark(QPainter& painter, const QPointF& at, const results::TradeoffPoint& point);

/// Draws the legend in rows of at most `room` pixels, from (`left`, `top`) on; without a painter only
/// measures. Returns the height taken.
double draw_mark_legend(QPainter* painter, double left, double top, double room,
                        const results::Tradeoff& tradeoff);

}  // namespace diefill::render
