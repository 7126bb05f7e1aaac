#include "process/measure/figures/zone_history.h"

#include "process/measure/earlier_instant.h"
#include "process/results/figure_table.h"
#include "process/results/probe_columns.h"

namespace diefill::process {
namespace {

void add_row(results::FillResult& result, const std::vector<Zone>& zones,
             std::vector<results::ProbeSeries>& histories) {
  result.figures.clear();
  add_zone_figures(result, zones);
  for (std::size_t k = 0; k < zones.size(); ++k)
    for (const double value :
         {result.powder.time, results::figure_of(result, zone_mass_figure(zones[k].name)),
          results::figure_of(result, zone_share_figure(zones[k].name)),
          results::figure_of(result, zone_solid_fraction_figure(zones[k].name))})
      histories[k].values.push_back(value);
}

}  // namespace

std::vector<results::ProbeSeries> zone_histories(const results::FillResult& result,
                                                 const std::vector<Zone>& zones) {
  if (zones.empty() || result.instants.empty()) return {};
  std::vector<results::ProbeSeries> histories;
  for (const Zone& zone : zones)
    histories.push_back({results::kZoneProbe + zone.name,
                         {"time", "mass", "share of mass", "solid fraction"},
                         {"s", "kg", "1", "1"},
                         {}});
  for (const results::Instant& instant : result.instants) {
    if (instant.time >= result.powder.time) continue;
    results::FillResult earlier = powder_at(result, instant);
    add_row(earlier, zones, histories);
  }
  results::FillResult end;
  end.powder = result.powder;
  end.solid_fraction = result.solid_fraction;
  end.cavity = result.cavity;
  end.other_cavities = result.other_cavities;
  add_row(end, zones, histories);
  return histories;
}

}  // namespace diefill::process
