#include "process/tradeoff/quantities.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "process/measure/figures/heap_slope.h"
#include "process/results/figure_table.h"
#include "process/results/none.h"
#include "process/scene/zones.h"

namespace diefill::process {
namespace {

using results::figure_called;

/// A figure of the result in the unit that it is shown in.
double value_of(const results::FillResult& result, const std::string& figure) {
  return figure_called(figure).shown.factor * results::figure_of(result, figure);
}

/// A figure as tradeoff.json and tradeoff.csv call it; `column` where that is not its label.
results::TradeoffQuantity quantity(const char* key, const char* figure, const char* column = "") {
  const results::Figure& entry = figure_called(figure);
  return {.key = key, .column = column, .name = entry.label, .unit = entry.shown.unit};
}

bool has_cavity(const results::FillResult& result) {
  return result.cavity.volume > 0;
}

/// What masses are divided by, and the unit they are in then.
struct Slice {
  double divisor = 1;  ///< mm or mm^2
  std::string unit = "g", rate = "g/s", volume = "mm^3";
};

Slice slice_of(const Scene& scene) {
  Slice slice;
  int axes = 0;
  for (const auto& period : scene.numerics.period)
    if (period) {
      slice.divisor *= 1e3 * *period;
      ++axes;
    }
  if (axes > 0) {
    const std::string per = axes == 1 ? "mm" : "mm^2";
    slice.unit = "g/" + per;
    slice.rate = "g/s/" + per;
    slice.volume = axes == 1 ? "mm^2" : axes == 2 ? "mm" : "1";
  }
  return slice;
}

/// One column of a probe's table.
std::vector<double> column(const results::ProbeSeries& series, std::size_t number) {
  std::vector<double> values;
  for (std::size_t k = number; k < series.values.size(); k += series.columns.size())
    values.push_back(series.values[k]);
  return values;
}

const results::ProbeSeries* probe_called(const results::FillResult& result, const std::string& name) {
  for (const auto& series : result.probes)
    if (series.name == name && !series.values.empty()) return &series;
  return nullptr;
}

/// m^3 that so much mass of model powder fills at rest: solid volume over the solid fraction of the powder
/// that is left (Bierwisch 2009, Eq. 4.2).
double volume_at_rest(double mass, const results::FillResult& result) {
  double left = 0, solid = 0;
  for (std::size_t k = 0; k < result.powder.position.size(); ++k) {
    left += result.powder.mass_of(k);
    solid += result.powder.solid_volume_of(k);
  }
  const double fraction = results::figure_of(result, "bulk_solid_fraction");
  return left > 0 && fraction > 0 ? mass / (left / solid) / fraction : kNone;
}

/// What the mass through a plane is of powder at rest, and what that of the real powder weighs.
void add_real_flow(std::vector<MeasuredQuantity>& all, const Scene& scene, const std::string& name,
                   const Slice& slice) {
  const auto volume = [name](const results::FillResult& result) {
    const auto* series = probe_called(result, name);
    return series == nullptr ? kNone : volume_at_rest(column(*series, 1).back(), result);
  };
  const auto add = [&](const std::string& key, const std::string& words, const std::string& unit,
                       double factor) {
    all.push_back({{.key = key + name, .name = words + name, .unit = unit, .decides = false},
                   [volume, factor](const results::FillResult& result) { return factor * volume(result); }});
  };
  add("volume_through_", "volume at rest through ", slice.volume, 1e9 / slice.divisor);
  const double apparent = scene.powder.apparent_density;
  if (apparent > 0)
    add("real_mass_through_", "mass of the real powder through ", slice.unit, 1e3 * apparent / slice.divisor);
}

/// Masses through the planes of the scene's flow probes, and their rates.
void add_flows(std::vector<MeasuredQuantity>& all, const Scene& scene) {
  const Slice slice = slice_of(scene);
  for (const ProbeSpec& probe : scene.probes) {
    if (probe.quantity != ProbeQuantity::flow) continue;
    const std::string name = probe.name;
    const double factor = 1e3 / slice.divisor;
    all.push_back({{.key = "mass_through_" + name, .name = "mass through " + name, .unit = slice.unit},
                   [name, factor](const results::FillResult& result) {
                     const auto* series = probe_called(result, name);
                     return series == nullptr ? kNone : factor * column(*series, 1).back();
                   }});
    all.push_back({{.key = "rate_through_" + name, .name = "rate through " + name, .unit = slice.rate},
                   [name, factor](const results::FillResult& result) {
                     const auto* series = probe_called(result, name);
                     return series == nullptr ? kNone
                                              : factor * steady_rate(column(*series, 0), column(*series, 1));
                   }});
    add_real_flow(all, scene, name, slice);
  }
}

void add_heaps(std::vector<MeasuredQuantity>& all, const Scene& scene) {
  for (const HeapSpec& heap : scene.measure.heaps) {
    const std::string key = heap_figure(heap.name);
    const results::Figure& slope = figure_called(key);
    all.push_back({{.key = key, .name = results::label_of(slope, heap.name), .unit = slope.shown.unit},
                   [key](const results::FillResult& result) { return value_of(result, key); }});
  }
}

/// m, length of a zone along a periodic axis, of which a slice of `period` is simulated. A box or a cylinder
/// may hold a part of the slice alone, whose mass does not grow with it.
double length_in_slice(const Zone& zone, Eigen::Index axis, double period) {
  double lower = std::max(zone.lower[axis], -0.5 * period), upper = std::min(zone.upper[axis], 0.5 * period);
  if (axis < 2) {
    lower = std::max(lower, zone.axis[axis] - zone.outer_radius);
    upper = std::min(upper, zone.axis[axis] + zone.outer_radius);
  }
  return upper - lower;
}

/// What the mass of a zone is divided by, mm or mm^2; NaN for one beside the slice.
double divisor_of(const Zone& zone, const Scene& scene) {
  double divisor = 1;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (const auto period = scene.numerics.period[static_cast<std::size_t>(axis)]) {
      const double length = length_in_slice(zone, axis, *period);
      divisor *= length > 0 ? 1e3 * length : kNone;
    }
  return divisor;
}

/// A figure's name without the unit at its end, which the quantity may have in another one.
std::string without_unit(const std::string& figure) {
  constexpr std::string_view kUnit = "_kg";
  return figure.ends_with(kUnit) ? figure.substr(0, figure.size() - kUnit.size()) : figure;
}

void add_zones(std::vector<MeasuredQuantity>& all, const Scene& scene) {
  const auto add = [&](const Zone& zone, const std::string& figure, const std::string& unit, double divisor) {
    all.push_back({{.key = without_unit(figure),
                    .name = results::label_of(figure_called(figure), zone.name),
                    .unit = unit},
                   [figure, divisor](const results::FillResult& result) {
                     return value_of(result, figure) / divisor;
                   }});
  };
  const Slice slice = slice_of(scene);
  for (const Zone& zone : zones_in(scene.text)) {
    add(zone, zone_mass_figure(zone.name), slice.unit, divisor_of(zone, scene));
    for (const std::string& figure : {zone_share_figure(zone.name), zone_solid_fraction_figure(zone.name)})
      add(zone, figure, figure_called(figure).shown.unit, 1);
  }
}

}  // namespace

double steady_rate(const std::vector<double>& time, const std::vector<double>& amount) {
  constexpr double kFrom = 0.2, kTo = 0.8;
  const double end = amount.empty() ? 0 : amount.back();
  if (!(end > 0)) return kNone;
  const auto first_above = [&](double share) {
    return static_cast<std::size_t>(
        std::find_if(amount.begin(), amount.end(), [&](double value) { return value >= share * end; }) -
        amount.begin());
  };
  const std::size_t from = first_above(kFrom), to = first_above(kTo);
  return from < to ? (amount[to] - amount[from]) / (time[to] - time[from]) : kNone;
}

std::vector<MeasuredQuantity> measured_quantities(const Scene& scene) {
  const Slice slice = slice_of(scene);
  results::TradeoffQuantity mass = quantity("filled_mass", "filled_mass_kg", "filled mass");
  mass.unit = slice.unit;
  results::TradeoffQuantity spread = quantity("solid_fraction_spread", "solid_fraction_field_std",
                                              "spatial standard deviation of the solid fraction");
  spread.scale = "solid_fraction";
  std::vector<MeasuredQuantity> all = {
      {mass,
       [slice](const results::FillResult& result) {
         return has_cavity(result) ? value_of(result, "filled_mass_kg") / slice.divisor : kNone;
       }},
      {quantity("solid_fraction", "solid_fraction_mean"),
       [](const results::FillResult& result) {
         return has_cavity(result) && result.summary.grains > 0 ? result.summary.mean : kNone;
       }},
      {spread,
       [](const results::FillResult& result) { return value_of(result, "solid_fraction_field_std"); }},
      {quantity("fill_level", "fill_height_mm", "fill level"),
       [](const results::FillResult& result) {
         return has_cavity(result) ? value_of(result, "fill_height_mm") : kNone;
       }},
      {quantity("bed_solid_fraction", "bulk_solid_fraction"),
       [](const results::FillResult& result) {
         return has_cavity(result) ? kNone : value_of(result, "bulk_solid_fraction");
       }},
  };
  add_flows(all, scene);
  add_heaps(all, scene);
  add_zones(all, scene);
  return all;
}

}  // namespace diefill::process
