// Bulk density of mono-disperse beds against rolling resistance, EPSD2 and constant directional torque, held
// against Hu 2024, section 5.2.
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "process/laboratory/bulk_density/poured_bed.h"
#include "process/laboratory/bulk_density/registry.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;
namespace laws = engine::laws;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A bed of the source; densities are of its original spheres of 0.5 mm.
struct Published {
  double rolling_friction, density;
};

/// Beds that differ in the coefficient of one rolling resistance.
struct Curve {
  std::string name;
  laws::AnyRolling::Parameters (*rolling)(double rolling_friction);
  std::vector<Published> beds;
};

laws::AnyRolling::Parameters epsd2(double rolling_friction) {
  return laws::Epsd2Rolling::Parameters{rolling_friction, sticky_shear_modulus()};
}

laws::AnyRolling::Parameters constant_torque(double rolling_friction) {
  return laws::LoadRolling::Parameters{rolling_friction};
}

/// Quick: all powder in a twentieth of the time, twenty times as densely.
constexpr double kPouring = 10, kQuickPouring = 0.5;  // s

/// `few`: those with published figures.
std::vector<Curve> curves(bool few) {
  Curve spring{"EPSD2", epsd2, {{0, 541}, {0.2, kUnknown}, {0.4, kUnknown}, {0.6, kUnknown}, {0.8, 484}}};
  Curve torque{
      "CDT", constant_torque, {{0, 541}, {0.04, kUnknown}, {0.08, kUnknown}, {0.12, kUnknown}, {0.16, 502}}};
  if (!few) return {spring, torque};
  for (Curve* curve : {&spring, &torque}) curve->beds = {curve->beds.front(), curve->beds.back()};
  return {spring, torque};
}

/// Of all beds, curve after curve. Where nothing resists rolling, all curves have the same bed.
std::vector<PouredBedFigures> pour_beds(const std::vector<Curve>& curves, const ExperimentOptions& options) {
  std::vector<PouredBed> beds;
  std::vector<std::size_t> bed_of;  // of a point
  std::optional<std::size_t> free_rolling;
  for (const auto& curve : curves)
    for (const auto& published : curve.beds) {
      const bool resists = published.rolling_friction > 0;
      bed_of.push_back(!resists && free_rolling ? *free_rolling : beds.size());
      if (bed_of.back() < beds.size()) continue;
      if (!resists) free_rolling = beds.size();
      PouredBed& bed = beds.emplace_back();
      bed.rolling = curve.rolling(published.rolling_friction);
      bed.pouring_time = options.quick ? kQuickPouring : kPouring;
    }
  std::vector<PouredBedFigures> figures(beds.size());
  side_by_side(options, beds.size(), "pouring beds", [&](std::size_t k, const TellShare& tell) {
    PouredBed bed = beds[k];
    bed.tell = tell;
    figures[k] = pour_bed(bed);
  });
  std::vector<PouredBedFigures> of_points;
  for (const std::size_t bed : bed_of) of_points.push_back(figures[bed]);
  return of_points;
}

/// `figures`: of the curve's beds, one after the other.
void add_curve(const Curve& curve, const PouredBedFigures* figures, results::ExperimentChart& chart,
               results::ExperimentResult& result) {
  ExperimentSeries measured{.name = curve.name, .x = {}, .y = {}};
  ExperimentSeries published{
      .name = curve.name + ", Hu 2024, l = 1", .role = Role::predicted, .x = {}, .y = {}};
  for (const auto& [friction, density] : curve.beds) {
    measured.x.push_back(friction);
    measured.y.push_back(figures->density);
    if (!std::isnan(density)) {
      published.x.push_back(friction);
      published.y.push_back(density);
    }
    const std::string at = curve.name + ", mu_r = " + std::to_string(friction).substr(0, 4);
    result.limits.push_back(
        {at + ": bulk density", figures->density, density, "kg/m3", "Hu 2024, section 5.2, l = 1"});
    result.limits.push_back({at + ": coordination number", figures->coordination, kUnknown, "", ""});
    result.limits.push_back({at + ": height of the bed", figures->height, kUnknown, "m", ""});
    result.limits.push_back(
        {at + ": kinetic energy over m g d at the end", figures->kinetic, kUnknown, "", ""});
    ++figures;
  }
  chart.series.push_back(measured);
  chart.series.push_back(published);
}

}  // namespace

void measure_mono_disperse_beds(const ExperimentOptions& options, results::ExperimentResult& result) {
  results::ExperimentChart chart;
  chart.name = "mono_disperse_density";
  chart.title = "Bulk density over rolling resistance";
  chart.subtitle = "0.5 mm spheres, JKR with 0.2 J/m2, scaled-up particles with l = 4; mean of 20 to 60 mm";
  chart.note = options.quick ? "Poured within 0.5 s; the source pours for 10 s."
                             : "Poured within 10 s, as in the source.";
  chart.x = {.label = "Rolling friction coefficient"};
  chart.y = {.label = "Bulk density [kg/m3]"};
  const auto all = curves(options.quick || options.published_only);
  const auto figures = pour_beds(all, options);
  const PouredBedFigures* of_curve = figures.data();
  for (const auto& curve : all) {
    add_curve(curve, of_curve, chart, result);
    of_curve += curve.beds.size();
  }
  result.charts.push_back(chart);
}

}  // namespace diefill::process::laboratory
