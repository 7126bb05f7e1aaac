// Wall friction of the calibrated lactoses under a smooth disc that turns at several normal stresses (Kottlan
// 2018, section 2.7.5): the angle over the disc's coefficient of friction, and the coefficient at which it is
// the measured one, between two that were tried. Stresses are held in one run, the highest first. Cells and
// sizes as in the shear tester.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/lactose/shear_cell.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char* kDisc = "disc";
constexpr double kStresses[] = {3e3, 2e3, 1.75e3, 1.5e3, 1.25e3, 1e3};  // Pa
constexpr double kHeld = 2, kRow = 0.02;  // d at the rim: at each stress, between rows of the probe
/// Of a stress: rows are those at which the disc presses as near to it as this.
constexpr double kNear = 0.04;

/// A powder on a disc.
struct DiscTest {
  std::string name;  ///< of the powder
  FilledCell filled;
  double friction;        ///< of the disc
  double measured_angle;  ///< deg, of the real powder on the real disc (Table 4)

  std::string run() const { return name + ", mu_s = " + plain(friction); }
};

std::vector<DiscTest> all_of(LabSize size) {
  const ShearCell cell = shear_cell(size);
  return {{"LH100", {lh100(), cell}, 0.1, 7.77},
          {"LH100", {lh100(), cell}, 0.2, 7.77},
          {"LH220", {lh220(), cell}, 0.15, 20.03},
          {"LH220", {lh220(), cell}, 0.2, 20.03}};
}

LabRun disc_friction_run(const DiscTest& one) {
  const FilledCell& filled = one.filled;
  std::string forces;
  for (const double stress : kStresses)
    forces += (forces.empty() ? "" : ", ") + with_unit(filled.force(stress), "N");
  std::string set = filled_cell_lines(filled, kDisc, "disc", 0);
  set += line("tool.disc.contact", "{ friction = " + friction_part(filled.powder, one.friction) + " }");
  set += line("step.press.forces", '[' + forces + ']');
  set += line("step.press.pause", with_unit(filled.seconds(kHeld), "s"));
  set += line("step.turn.start", "{ with = \"press\", force = " +
                                     with_unit(0.98 * filled.force(kStresses[0]), "N") + ", on = \"disc\" }");
  set += line("step.turn.speed_limit", turns_a_minute(filled.turn_speed()));
  set += line("probe.disc.interval", with_unit(filled.seconds(kRow), "s"));
  return {one.run(), "disc_friction.toml", {set, {}}};
}

/// Radius of the cell, which stresses are computed with, over that of the disc, at whose rim friction ends.
double cell_over_disc(const FilledCell& filled) {
  return filled.radius() / (filled.radius() - ShearCell::kRimGap * filled.powder.diameter());
}

/// Mean over the rows near each stress while the disc turns, but for its first grain diameter.
std::vector<MeanStress> points_of(const SeedResults& seed, const DiscTest& one) {
  const auto spans = spans_of(seed, one.run(), kDisc);
  std::vector<MeanStress> points;
  if (spans.empty()) return points;
  const ShearCurve curve = shear_curve(seed, one.run(), kDisc, one.filled);
  const double from = spans.back().start + one.filled.seconds(1);
  for (const double stress : kStresses) {
    ShearCurve near;
    for (std::size_t k = 0; k < curve.time.size(); ++k) {
      if (curve.time[k] < from || std::abs(curve.normal[k] - stress) > kNear * stress) continue;
      near.time.push_back(curve.time[k]), near.normal.push_back(curve.normal[k]);
      near.shear.push_back(curve.shear[k] * cell_over_disc(one.filled));
    }
    if (!near.time.empty()) points.push_back(mean_stress(near, near.time.front(), near.time.back()));
  }
  return points;
}

/// tan of the angle: least squares of tau = sigma tan(phi_x).
double slope_of(const std::vector<MeanStress>& points) {
  double products = 0, squares = 0;
  for (const MeanStress& point : points)
    products += point.normal * point.shear, squares += point.normal * point.normal;
  return products / squares;
}

double angle_of(const SeedResults& seed, const DiscTest& one) {
  return std::atan(slope_of(points_of(seed, one))) * 180 / std::numbers::pi;
}

/// Coefficient of the disc with which the angle is the measured one, on the line through both.
double fitted_friction(const SeedResults& seed, const DiscTest& low, const DiscTest& high) {
  const double first = angle_of(seed, low), second = angle_of(seed, high);
  return low.friction + (low.measured_angle - first) / (second - first) * (high.friction - low.friction);
}

using Role = results::ExperimentSeries::Role;

results::ExperimentChart disc_friction_chart(const std::vector<DiscTest>& all, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "disc_friction";
  chart.title = "Wall friction of lactose on a turning disc";
  chart.subtitle = "Spheres of one size, calibrated sets; lines through the origin (Kottlan 2018)";
  chart.x = {.label = "Normal stress [kPa]", .lower = 0, .upper = 3.5};
  chart.y = {.label = "Shear stress [kPa]", .lower = 0};
  const auto add_line = [&](const std::string& name, Role role, double slope) {
    results::ExperimentSeries series{.name = name, .role = role, .x = {}, .y = {}};
    for (const double stress : {0.0, 1.0, 2.0, 3.0})
      series.x.push_back(stress), series.y.push_back(stress * slope);
    chart.series.push_back(std::move(series));
  };
  for (const DiscTest& one : all) {
    if (!seed.has(one.run())) continue;
    const auto points = points_of(seed, one);
    results::ExperimentSeries series{.name = one.run(), .role = Role::points, .x = {}, .y = {}};
    for (const MeanStress& point : points)
      series.x.push_back(1e-3 * point.normal), series.y.push_back(1e-3 * point.shear);
    chart.series.push_back(std::move(series));
    add_line(one.run() + ", line", Role::predicted, slope_of(points));
    chart.series.back().in_legend = false;
  }
  for (std::size_t k = 0; k < all.size(); k += 2)
    add_line(all[k].name + ", measured", Role::published,
             std::tan(all[k].measured_angle * std::numbers::pi / 180));
  return chart;
}

}  // namespace

LabPlan plan_disc_friction(const LabSetting& setting) {
  const std::vector<DiscTest> all = all_of(setting.size);
  LabPlan plan;
  for (const DiscTest& one : all) {
    plan.runs.push_back(disc_friction_run(one));
    plan.quantities.push_back({.id = one.run(),
                               .quantity = one.run() + ": wall friction angle",
                               .unit = "deg",
                               .runs = {one.run()},
                               .value = [=](const SeedResults& seed) { return angle_of(seed, one); }});
  }
  for (std::size_t k = 0; k < all.size(); k += 2) {
    const DiscTest &low = all[k], &high = all[k + 1];
    plan.quantities.push_back(
        {.id = low.name + "-mu_wall",
         .quantity = low.name + ": coefficient of the disc for the measured angle",
         .unit = "1",
         .runs = {low.run(), high.run()},
         .value = [=](const SeedResults& seed) { return fitted_friction(seed, low, high); }});
  }
  plan.charts = [all](const SeedResults& seed) { return std::vector{disc_friction_chart(all, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
