// Line charts, scatter plots and histograms with several curves: axes with units, legend, error bars, log
// scales.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace diefill::render {

/// How a curve is drawn.
enum class CurveStyle {
  kLine,            ///< straight lines from point to point; NaN leaves a gap, a point between gaps is a dot
  kMarkers,         ///< points only
  kLineAndMarkers,  ///< both
  kBars,            ///< histogram bars from zero, centred on x, as wide as the spacing of x
  /// No data, but what data are compared with: grey and broken, a level dash at each point of a row; two
  /// points are the ends of a line.
  kReference
};

/// One curve. Curves of data are told apart by colour, dashes and marker, so that they also read in grey
/// print. A line without a name has the colour of the curve before it.
struct Curve {
  std::string name;          ///< in the legend; empty: not in the legend
  std::vector<double> x, y;  ///< equal lengths, in the axes' units; NaN where there is no value
  CurveStyle style = CurveStyle::kLine;
  std::vector<double> y_error;    ///< half length of an error bar at each point; empty: none
  std::vector<double> band = {};  ///< half height of a shaded band round the line at each point; empty: none
};

/// One axis. Limits that are NaN come from the data, widened to round numbers, and to a twentieth of the axis
/// beyond the outermost mark; zero stays a limit where nothing lies beyond it.
struct ChartAxis {
  std::string label;  ///< with unit, such as "Fill level [mm]"
  double lower = std::numeric_limits<double>::quiet_NaN();
  double upper = std::numeric_limits<double>::quiet_NaN();
  bool logarithmic = false;
  /// Whether the label ends with [°] or [deg]: ticks then stand at 15, 30, 45 ... degrees.
  bool in_degrees() const;
};

/// A remark pinned to an x value, above the chart.
struct ChartMarker {
  double x = 0;
  std::string text;
};

/// A whole chart.
struct Chart {
  std::string title, subtitle;
  ChartAxis x, y;
  std::vector<Curve> curves;
  std::vector<ChartMarker> markers;
  std::string note;   ///< small print at the foot
  double pixels = 1;  ///< picture points a layout point: 2 doubles the resolution
};

/// Draws the chart as a PNG of 1600 x 1000 pixels (taller where the legend is long). Throws
/// std::runtime_error where a curve's arrays differ in length, a logarithmic axis has limits that are not
/// positive, or the file cannot be written.
void draw_chart(const std::filesystem::path& png, const Chart& chart);

/// Draws the chart as one PDF page of lines and embedded type, 16 cm wide, that scales without loss. Throws
/// as draw_chart.
void draw_chart_pdf(const std::filesystem::path& pdf, const Chart& chart);

}  // namespace diefill::render
