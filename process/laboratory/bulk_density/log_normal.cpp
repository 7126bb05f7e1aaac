// Bulk density and coordination of beds of log-normal sizes against the width of the distribution, held
// against Hu 2024, section 6.3.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "process/laboratory/bulk_density/log_normal_bed.h"
#include "process/laboratory/bulk_density/registry.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Of the source's floor, which is periodic, along each way: the largest spheres still fit in three times.
constexpr double kQuickWidth = 0.35;

/// A bed of the source, original spheres and 0.2 J/m^2.
struct Published {
  double variation, density, coordination;
};

constexpr const char* kSource = "Hu 2024, section 6.3, l = 1";

results::ExperimentChart chart_of(const std::string& name, const std::string& title, const std::string& unit,
                                  bool quick) {
  results::ExperimentChart chart;
  chart.name = name;
  chart.title = title;
  chart.subtitle =
      "1 mm spheres in the mean, JKR with 0.2 J/m2, scaled-up particles with l = 4; mean of 20 to 60 mm";
  chart.note =
      quick ? "Periodic floor, an eighth of the area in the source." : "As much powder as in the source.";
  chart.x = {.label = "Standard deviation of the diameter over its mean"};
  chart.y = {.label = unit};
  return chart;
}

/// The beds of `published`. The wide spreads take longest: they come first.
std::vector<LogNormalBedFigures> settle_beds(const std::vector<Published>& published,
                                             const ExperimentOptions& options) {
  std::vector<LogNormalBedFigures> figures(published.size());
  side_by_side(options, published.size(), "settling beds", [&](std::size_t k, const TellShare& tell) {
    const std::size_t last_first = published.size() - 1 - k;
    LogNormalBed bed;
    bed.variation = published[last_first].variation;
    bed.share_of_width = options.quick ? kQuickWidth : 1;
    bed.tell = tell;
    figures[last_first] = settle_log_normal_bed(bed);
  });
  return figures;
}

}  // namespace

void measure_log_normal_beds(const ExperimentOptions& options, results::ExperimentResult& result) {
  const std::vector<Published> ends = {{0, 573, 4.82}, {0.8, 625, 4.38}}, all = {{0, 573, 4.82},
                                                                                 {0.2, kUnknown, kUnknown},
                                                                                 {0.4, kUnknown, kUnknown},
                                                                                 {0.6, kUnknown, kUnknown},
                                                                                 {0.8, 625, 4.38}};
  ExperimentSeries density{.name = "here", .x = {}, .y = {}},
      coordination = density, published_density{.name = kSource, .role = Role::predicted, .x = {}, .y = {}},
      published_coordination = published_density;
  const std::vector<Published>& beds = options.quick || options.published_only ? ends : all;
  const auto measured = settle_beds(beds, options);
  for (std::size_t k = 0; k < beds.size(); ++k) {
    const auto& [variation, dense, touching] = beds[k];
    const auto& figures = measured[k];
    for (ExperimentSeries* series : {&density, &coordination}) series->x.push_back(variation);
    density.y.push_back(figures.density);
    coordination.y.push_back(figures.coordination);
    if (!std::isnan(dense)) {
      for (ExperimentSeries* series : {&published_density, &published_coordination})
        series->x.push_back(variation);
      published_density.y.push_back(dense);
      published_coordination.y.push_back(touching);
    }
    const std::string at = "s_d / m_d = " + std::to_string(variation).substr(0, 3);
    result.limits.push_back({at + ": bulk density", figures.density, dense, "kg/m3", kSource});
    result.limits.push_back({at + ": coordination number", figures.coordination, touching, "", kSource});
    result.limits.push_back({at + ": height of the bed", figures.height, kUnknown, "m", ""});
    result.limits.push_back(
        {at + ": kinetic energy over m g d at the end", figures.kinetic, kUnknown, "", ""});
  }
  auto densities = chart_of("log_normal_density", "Bulk density over the width of the size distribution",
                            "Bulk density [kg/m3]", options.quick);
  densities.series = {density, published_density};
  auto contacts =
      chart_of("log_normal_coordination", "Coordination number over the width of the size distribution",
               "Mean coordination number", options.quick);
  contacts.series = {coordination, published_coordination};
  result.charts = {densities, contacts};
}

}  // namespace diefill::process::laboratory
