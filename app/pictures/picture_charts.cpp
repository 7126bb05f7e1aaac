// Pictures that are charts: profiles, histograms, fill levels; all sources in one.
#include <algorithm>
#include <stdexcept>

#include "app/pictures/picture_files.h"
#include "process/measure/coordination.h"
#include "process/measure/fields/box_map.h"
#include "process/measure/figures/variation.h"
#include "process/measure/measure.h"
#include "render/charts/variation_charts.h"

namespace diefill::app {
namespace {

std::string chart_subtitle(const PictureRequest& request) {
  return request.sources.size() > 1
             ? std::string()
             : title_of(request, request.sources.front()) + ", " + subtitle_of(request.sources.front());
}

/// Over azimuth and height of a ring; over the travel and height of any other cavity.
results::Field2D side_field(const PictureRequest& request, const results::FillResult& result) {
  if (!result.cavity.is_ring)
    return process::box_map(result, process::BoxView::kSide, request.averaging_width);
  return process::cylindrical_map(result.powder, result.solid_fraction, result.tools, result.cavity,
                                  request.averaging_width);
}

Pictures spread_pictures(const PictureRequest& request, const std::string& kind, const std::string& what,
                         results::SpreadProfile (*profile_of)(const results::Field2D&)) {
  const bool rings =
      std::ranges::all_of(request.sources, [](const auto& source) { return source.result.cavity.is_ring; });
  const std::string across = rings ? "azimuth" : "the cross-section";
  std::vector<render::Named<results::SpreadProfile>> profiles;
  for (const auto& source : request.sources) {
    const auto& result = source.result;
    profiles.push_back({legend_of(request, source), profile_of(side_field(request, result))});
  }
  return write_chart(request, kind, render::spread_chart(profiles, what, chart_subtitle(request), across));
}

}  // namespace

Pictures make_height_profile(const PictureRequest& request) {
  return spread_pictures(request, "height_profile", "Solid fraction over height",
                         process::profile_over_height);
}

Pictures make_azimuth_profile(const PictureRequest& request) {
  require_ring(request, "azimuth-profile", "height-profile or plan-map");
  return spread_pictures(request, "azimuth_profile", "Solid fraction over azimuth",
                         process::profile_over_azimuth);
}

Pictures make_histogram(const PictureRequest& request) {
  constexpr double kBin = 0.01;
  std::vector<render::Named<results::Histogram>> histograms;
  for (const auto& source : request.sources)
    histograms.push_back(
        {legend_of(request, source),
         process::histogram("solid fraction", "1", process::counted_fractions(source.result.solid_fraction),
                            kBin)});
  auto chart = render::histogram_chart(histograms, "Solid fraction of grains", chart_subtitle(request));
  chart.note = "Closed Voronoi cells in the cavity";
  return write_chart(request, "histogram", chart);
}

Pictures make_fill_level(const PictureRequest& request) {
  constexpr int kBins = 72;
  std::vector<render::Named<results::Profile>> profiles;
  std::vector<double> depths;  // mm
  for (const auto& source : request.sources) {
    const auto& cavity = source.result.cavity;
    profiles.push_back(
        {legend_of(request, source), cavity.is_ring ? process::fill_level(source.result.powder, cavity, kBins)
                                                    : process::fill_level_along_travel(source.result)});
    depths.push_back(1e3 * (cavity.upper_corner.z() - cavity.lower_corner.z()));
  }
  return write_chart(request, "fill_level",
                     render::fill_level_chart(profiles, depths, chart_subtitle(request)));
}

Pictures make_coordination(const PictureRequest& request) {
  std::vector<render::Named<results::Histogram>> histograms;
  for (const auto& source : request.sources) {
    const auto& result = source.result;
    const auto numbers = process::coordination_numbers(result.powder);
    std::vector<double> counted;
    for (std::size_t k = 0; k < numbers.size(); ++k)
      if (result.cavity.volume <= 0 || result.solid_fraction.in_cavity[k] != 0) counted.push_back(numbers[k]);
    auto histogram = process::histogram("grains touched", "1", counted, 1);
    for (double& middle : histogram.middle) middle -= 0.5;  // whole numbers stand in the middle of their bars
    histograms.push_back({legend_of(request, source), std::move(histogram)});
  }
  auto chart = render::histogram_chart(histograms, "Coordination number", chart_subtitle(request));
  chart.note = "Other grains that a grain in the cavity touches; walls not counted";
  return write_chart(request, "coordination", chart);
}

}  // namespace diefill::app
