#include "process/laboratory/published/sawing/groove_charts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace diefill::process::laboratory::sawing {
namespace {

using results::ExperimentChart;
using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr double kCentre = 30, kSides = 100;  // um, of the groove's surface
constexpr double kAtWalls = 0.5;              // r_c, of the gap

/// Speed over x(radius), of all of the gap but its borders.
template <class Abscissa>
FittedLine fit(const std::vector<GapSpeed>& gap, const Abscissa& x) {
  std::vector<double> place, speed;
  for (const GapSpeed& at : gap) {
    if (at.radius < gap.front().radius + kAtWalls || at.radius > gap.back().radius - kAtWalls) continue;
    place.push_back(x(at.radius));
    speed.push_back(at.speed);
  }
  return fit_line(place, speed);
}

ExperimentSeries series_of(const std::string& name, Role role) {
  return {.name = name, .role = role, .x = {}, .y = {}};
}

void add_viscosities(const std::string& name, const ViscosityCurve& curve, double published,
                     ExperimentChart& chart) {
  ExperimentSeries here = series_of(name, Role::measured),
                   source = series_of(name + ", published", Role::published);
  for (std::size_t k = 0; k < curve.rates.size(); ++k) {
    here.x.push_back(curve.rates[k]), here.y.push_back(ReducedUnits::viscosity * curve.figures[k].viscosity);
    source.x.push_back(curve.rates[k]), source.y.push_back(published);
  }
  chart.series.push_back(here);
  chart.series.push_back(source);
}

/// Adds a series for each run, which `fill` gives its points.
template <class Fill>
void add_runs(const std::vector<NamedGroove>& all, Role role, ExperimentChart& chart, const Fill& fill) {
  for (const NamedGroove& one : all) {
    chart.series.push_back(series_of(one.name, role));
    fill(one, chart.series.back());
  }
}

}  // namespace

FittedLine line_through(const std::vector<GapSpeed>& gap) {
  return fit(gap, [](double radius) { return radius; });
}

double speed_at(const std::vector<GapSpeed>& gap, double radius) {
  return fit(gap, [](double r) { return std::log(r); }).at(std::log(radius));
}

double share_at_centre(const GrooveFigures& figures) {
  double centre = 0, all = 0;
  for (const GrooveStress& stretch : figures.stress) {
    all += stretch.stress * stretch.width;
    if (ReducedUnits::micrometres * std::abs(stretch.place) < kCentre)
      centre += stretch.stress * stretch.width;
  }
  return centre / all;
}

double stress_at_sides(const GrooveFigures& figures) {
  double sum = 0, count = 0;
  for (const GrooveStress& stretch : figures.stress)
    if (ReducedUnits::micrometres * std::abs(stretch.place) > kSides) sum += stretch.stress, ++count;
  return sum / count;
}

double late_change(const GrooveFigures& figures) {
  const std::vector<double>& distance = figures.distance;
  const std::size_t all = distance.size(), tenth = std::max<std::size_t>(1, all / 10), third = all / 3;
  const auto mean_from = [&](std::size_t first) {
    double sum = 0;
    for (std::size_t k = first; k < first + tenth; ++k) sum += distance.at(k);
    return sum / static_cast<double>(tenth);
  };
  return mean_from(all - tenth) - mean_from(all - third - tenth);
}

const GrainStress& grains_of(const GrooveFigures& figures, double size) {
  for (const GrainStress& one : figures.grains)
    if (one.size == size) return one;
  throw std::out_of_range("no grains of this size in the groove");
}

ExperimentChart viscosity_chart(const ViscosityCurve& fluid, const ViscosityCurve& slurry) {
  ExperimentChart chart;
  chart.name = "wire_sawing_viscosity";
  chart.title = "Viscosity of fluid and slurry under shear";
  chart.subtitle = "DPD, sheared box; slurry with grains of 6, 10, 14 and 20 um (Bierwisch 2009, A.2)";
  chart.x = {.label = "Shear rate, reduced [1]", .lower = 0};
  chart.y = {.label = "Viscosity [mPa s]", .lower = 0};
  add_viscosities("fluid", fluid, 0.085, chart);
  add_viscosities("slurry", slurry, 0.34, chart);
  return chart;
}

ExperimentChart gap_chart(const std::vector<GapSpeed>& gap, double wire_speed) {
  ExperimentChart chart;
  chart.name = "wire_sawing_gap";
  chart.title = "Speed of the fluid between wire and ingot";
  chart.subtitle = "Wire of 100 um in a groove of 140 um, no grains";
  chart.x = {.label = "Distance from the wire [um]"};
  chart.y = {.label = "Speed over that of the wire [1]"};
  ExperimentSeries here = series_of("diefill", Role::points),
                   line = series_of("no slip, line", Role::predicted);
  const GrooveCase shape;
  for (const GapSpeed& at : gap) {
    here.x.push_back(ReducedUnits::micrometres * (at.radius - shape.wire_radius));
    here.y.push_back(at.speed / wire_speed);
  }
  line.x = {0, ReducedUnits::micrometres * (shape.groove_radius - shape.wire_radius)};
  line.y = {1, 0};
  chart.series = {here, line};
  return chart;
}

ExperimentChart stress_chart(const std::vector<NamedGroove>& all) {
  ExperimentChart chart;
  chart.name = "wire_sawing_stress";
  chart.title = "Normal stress on the groove's surface";
  chart.subtitle = "Over the pressure on the wire; the stress on the lid above is taken off";
  chart.x = {.label = "Tangential coordinate [um]"};
  chart.y = {.label = "Normal stress over pressure on the wire [1]"};
  add_runs(all, Role::measured, chart, [](const NamedGroove& one, ExperimentSeries& series) {
    for (const GrooveStress& stretch : one.figures.stress) {
      series.x.push_back(ReducedUnits::micrometres * stretch.place);
      series.y.push_back(stretch.stress * ReducedUnits::pressure_of_process / one.pressure);
    }
  });
  return chart;
}

ExperimentChart section_chart(const NamedGroove& one, std::size_t number) {
  ExperimentChart chart;
  chart.name = "wire_sawing_section_" + std::to_string(number);
  chart.title = "Section across the wire: " + one.name;
  chart.subtitle = "Particles of fluid, grains, wire and ingot at the end of the run";
  chart.x = {.label = "Transverse coordinate [um]", .lower = -170, .upper = 170};  // both axes to one scale
  chart.y = {.label = "Height above the centre of the round bottom [um]"};
  using Part = SectionPoint::Part;
  constexpr std::pair<Part, const char*> kParts[] = {
      {Part::fluid, "fluid"}, {Part::grain, "grains"}, {Part::tool, "wire and ingot"}};
  for (const auto& [part, name] : kParts) {
    ExperimentSeries series = series_of(name, Role::points);
    for (const SectionPoint& point : one.figures.section) {
      if (point.part != part) continue;
      series.x.push_back(ReducedUnits::micrometres * point.x);
      series.y.push_back(ReducedUnits::micrometres * point.z);
    }
    chart.series.push_back(series);
  }
  return chart;
}

ExperimentChart distance_chart(const std::vector<NamedGroove>& all) {
  ExperimentChart chart;
  chart.name = "wire_sawing_distance";
  chart.title = "Gap between wire and ingot while the wire is pressed into the slurry";
  chart.subtitle = "Grains of 6, 10, 14 and 20 um, 25 percent by volume";
  chart.x = {.label = "Time, reduced [1]"};
  chart.y = {.label = "Gap between wire and ingot [um]", .lower = 0};
  add_runs(all, Role::predicted, chart, [](const NamedGroove& one, ExperimentSeries& series) {
    const std::size_t every = std::max<std::size_t>(1, one.figures.time.size() / 200);
    for (std::size_t k = 0; k < one.figures.time.size(); k += every) {
      series.x.push_back(one.figures.time[k]);
      series.y.push_back(ReducedUnits::micrometres * one.figures.distance[k]);
    }
  });
  return chart;
}

ExperimentChart grain_chart(const std::vector<NamedGroove>& all) {
  ExperimentChart chart;
  chart.name = "wire_sawing_grains";
  chart.title = "Grains at a stress above 5 N/mm2";
  chart.subtitle = "Share of the grains of each size, over the sampled steps";
  chart.x = {.label = "Grain size [um]"};
  chart.y = {.label = "Share of grains [1]", .lower = 0};
  add_runs(all, Role::measured, chart, [](const NamedGroove& one, ExperimentSeries& series) {
    for (const GrainStress& grains : one.figures.grains) {
      series.x.push_back(ReducedUnits::micrometres * grains.size);
      series.y.push_back(grains.middle + grains.high);
    }
  });
  return chart;
}

}  // namespace diefill::process::laboratory::sawing
