// The pictures of a run as bytes for a report, drawn by render's own functions.
#pragma once

#include <vector>

#include "process/results/fill_result.h"
#include "render/chart.h"
#include "render/pictures.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// Everything that draw_all() draws, so that a kind of picture added there is in reports too, and every
/// further section, map and profile of the result.
std::vector<Figure> pictures_of(const results::FillResult& result);

/// The tools alone, cut open.
std::vector<Figure> tool_views(const results::FillResult& result);

/// The schedule over time; empty for results that do not hold it.
std::vector<Figure> timeline_of(const results::FillResult& result);

/// One field with a scale given.
Figure field_picture(const results::Field2D& field, const std::string& title, const std::string& subtitle,
                     const ColourRange& range, const std::string& caption);

/// One chart.
Figure chart_picture(const Chart& chart, const std::string& caption);

}  // namespace diefill::render::report
