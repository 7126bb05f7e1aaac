// The pictures of a run as bytes for a report, drawn by render's own functions.
#pragma once

#include <vector>

#include "process/results/fill_result.h"
#include "render/charts/chart.h"
#include "render/fields/field_style.h"
#include "render/fields/pictures.h"
#include "render/report/document.h"

namespace diefill::render::report {

/// What pictures of a run share with others of the report.
struct SharedPictures {
  ColourRange range = kRangeFromData;  ///< of the solid fraction, of the whole report
  /// The result as of each further cavity (Run::other_cavities); nullptr: none.
  const std::vector<results::FillResult>* other_cavities = nullptr;
};

/// Everything that draw_all() draws, so that a kind of picture added there is in reports too, every further
/// profile of the result, and the maps of its further cavities.
std::vector<Figure> pictures_of(const results::FillResult& result, const SharedPictures& shared = {});

/// The tools alone, cut open.
std::vector<Figure> tool_views(const results::FillResult& result);

/// The schedule over time; empty for results that do not hold it.
std::vector<Figure> timeline_of(const results::FillResult& result);

/// One field with a scale given.
Figure field_picture(const results::Field2D& field, const std::string& title, const std::string& subtitle,
                     const ColourRange& range, const std::string& caption, const FieldStyle& style = {});

/// One difference, in colours about zero; its scale from the data.
Figure difference_picture(const results::Field2D& difference, const std::string& title,
                          const std::string& subtitle, const std::string& caption,
                          const FieldStyle& style = {});

/// One chart.
Figure chart_picture(const Chart& chart, const std::string& caption);

}  // namespace diefill::render::report
