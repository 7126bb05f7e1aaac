// Pre-shear and yield loci of the calibrated lactoses in a cell with a vaned head (Kottlan 2018, section
// 2.7.4): pre-shear at 3 kPa until the torque is steady, free of torque, unloaded, sheared again; all normal
// stresses from the same pre-sheared bed. Spheres of one size; the loose bed is pressed by the head at once.
// Coarse: a cell of 10 d and 900 spheres; medium: 16 d, 4,000 spheres; published: a quarter of that speed.
#include <cmath>
#include <stdexcept>

#include "process/continuum/wedge_hopper.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"
#include "process/laboratory/published/lactose/sheared_bed.h"
#include "process/results/storage/result_file.h"

namespace diefill::process::laboratory {
namespace {

using continuum::MohrCircle, continuum::StressPoint, continuum::YieldLocus;

/// One powder, its published figures and the measured wall friction for the design of a hopper.
struct ShearedPowder {
  std::string id;
  ShearTest test;
  YieldLocus published;
  double published_preshear, wall_angle;  ///< Pa, deg
};

std::vector<ShearedPowder> powders(LabSize size) {
  const ShearCell cell = shear_cell(size);
  const std::vector<double> stresses = {2e3, 1.75e3, 1.5e3, 1.25e3, 1e3};
  return {{"L100", {"LH100", {lh100(), cell}, stresses}, {0.586, 184}, 1.91e3, 7.77},
          {"L220", {"LH220", {lh220(), cell}, stresses}, {0.457, 763}, 2.39e3, 20.03}};
}

YieldLocus locus_of(const SeedResults& seed, const ShearedPowder& one) {
  return locus_of(seed, one.test);
}

StressPoint preshear_of(const SeedResults& seed, const ShearedPowder& one) {
  return preshear_of(seed, one.test);
}

/// Throws results::ResultError where the shear test leads to no hopper.
continuum::WedgeHopper hopper_of(const SeedResults& seed, const ShearedPowder& one) {
  const YieldLocus locus = locus_of(seed, one);
  const StressPoint steady = preshear_of(seed, one);
  try {
    return continuum::wedge_hopper({.preshear_normal = steady.normal,
                                    .preshear = steady.shear,
                                    .slope = locus.slope,
                                    .cohesion = locus.cohesion,
                                    .wall_angle = one.wall_angle,
                                    .bulk_density = 1545 * fraction_of(seed, one.test)});
  } catch (const std::invalid_argument& reason) {
    throw results::ResultError(reason.what());
  }
}

using Value = double (*)(const SeedResults&, const ShearedPowder&);

LabQuantity quantity(const ShearedPowder& one, const std::string& id, const std::string& what,
                     const std::string& unit, Value value) {
  LabQuantity of{.id = id,
                 .quantity = "",
                 .unit = "",
                 .runs = one.test.run_names(),
                 .value = [=](const SeedResults& seed) { return value(seed, one); }};
  if (!what.empty()) of.quantity = one.test.name + ": " + what, of.unit = unit;
  return of;
}

double none_unless_cohesive(const SeedResults& seed, const ShearedPowder& one,
                            double (*of)(const continuum::WedgeHopper&)) {
  const YieldLocus locus = locus_of(seed, one);
  if (!(locus.cohesion > 0 && locus.slope > 0)) return std::nan("");
  return of(hopper_of(seed, one));
}

void add_published(LabPlan& plan, const ShearedPowder& one) {
  const std::string id = one.id + "-pred-";
  plan.quantities.push_back(quantity(
      one, id + "tau_pre", "", "",
      [](const SeedResults& seed, const ShearedPowder& of) { return 1e-3 * preshear_of(seed, of).shear; }));
  plan.quantities.push_back(quantity(
      one, id + "tau_0", "", "",
      [](const SeedResults& seed, const ShearedPowder& of) { return 1e-3 * locus_of(seed, of).cohesion; }));
  plan.quantities.push_back(
      quantity(one, id + "k_YL", "", "",
               [](const SeedResults& seed, const ShearedPowder& of) { return locus_of(seed, of).slope; }));
}

void add_own(LabPlan& plan, const ShearedPowder& one) {
  const auto add = [&](const char* id, const char* what, const char* unit, Value value) {
    plan.quantities.push_back(quantity(one, one.test.name + '-' + id, what, unit, value));
  };
  add("f_c", "unconfined yield strength", "kPa", [](const SeedResults& seed, const ShearedPowder& of) {
    return 1e-3 * continuum::unconfined_circle(locus_of(seed, of)).major();
  });
  add("sigma_1", "major consolidation stress", "kPa", [](const SeedResults& seed, const ShearedPowder& of) {
    return 1e-3 * continuum::steady_circle(locus_of(seed, of), preshear_of(seed, of)).major();
  });
  add("ff_c", "flow function, sigma_1 over f_c", "1", [](const SeedResults& seed, const ShearedPowder& of) {
    return continuum::flow_function(locus_of(seed, of), preshear_of(seed, of));
  });
  add("phi_e", "effective angle of internal friction", "deg",
      [](const SeedResults& seed, const ShearedPowder& of) {
        return continuum::effective_angle(
            continuum::steady_circle(locus_of(seed, of), preshear_of(seed, of)));
      });
  add("phi", "solid fraction after pre-shear", "1",
      [](const SeedResults& seed, const ShearedPowder& of) { return fraction_of(seed, of.test); });
  add("half_angle", "half angle of a wedge hopper for mass flow", "deg",
      [](const SeedResults& seed, const ShearedPowder& of) {
        return none_unless_cohesive(seed, of,
                                    [](const continuum::WedgeHopper& hopper) { return hopper.half_angle; });
      });
  add("slot", "slot of that hopper without arching", "m",
      [](const SeedResults& seed, const ShearedPowder& of) {
        return none_unless_cohesive(seed, of,
                                    [](const continuum::WedgeHopper& hopper) { return hopper.slot_width; });
      });
}

/// One shear at half the speed: a test slow enough gives the same stresses.
ShearTest at_half_the_speed(ShearTest test) {
  test.name += ", half the speed";
  test.filled.cell.rim_speed /= 2;
  test.stresses.resize(1);
  return test;
}

void add_speed_check(LabPlan& plan, const ShearedPowder& one) {
  const ShearTest slow = at_half_the_speed(one.test);
  const double stress = slow.stresses.front();
  plan.runs.push_back(run_of(slow, stress));
  const auto add = [&](const char* id, const char* what, double (*of)(const SeedResults&, const ShearTest&)) {
    plan.quantities.push_back(
        {.id = one.test.name + '-' + id,
         .quantity = one.test.name + ": " + what + " at half the speed, over that at the full speed",
         .unit = "1",
         .runs = {one.test.run_name(stress), slow.run_name(stress)},
         .value = [test = one.test, slow, of](const SeedResults& seed) {
           return of(seed, slow) / of(seed, test);
         }});
  };
  add("speed-preshear", "shear stress in pre-shear",
      [](const SeedResults& seed, const ShearTest& of) { return preshear_of(seed, of).shear; });
  add("speed-strength", "shear strength at 2 kPa",
      [](const SeedResults& seed, const ShearTest& of) { return strengths_of(seed, of).front().shear; });
}

/// Largest of both powders: pre-shear over the locus at its normal stress.
LabQuantity above_the_locus(const std::vector<ShearedPowder>& all) {
  LabQuantity of{
      .id = "SCR-invalid", .quantity = "", .unit = "", .runs = {}, .value = [=](const SeedResults& seed) {
        double largest = 0;
        for (const ShearedPowder& one : all) {
          const StressPoint steady = preshear_of(seed, one);
          largest = std::fmax(largest, steady.shear / locus_of(seed, one).at(steady.normal));
        }
        return largest;
      }};
  for (const ShearedPowder& one : all)
    for (const auto& run : one.test.run_names()) of.runs.push_back(run);
  return of;
}

using Role = results::ExperimentSeries::Role;

results::ExperimentSeries series_of(const std::string& name, Role role,
                                    const std::vector<StressPoint>& points) {
  results::ExperimentSeries series{.name = name, .role = role, .x = {}, .y = {}};
  for (const StressPoint& point : points) {
    series.x.push_back(1e-3 * point.normal);
    series.y.push_back(1e-3 * point.shear);
  }
  return series;
}

std::vector<StressPoint> upper_half(const MohrCircle& circle) {
  constexpr int kPoints = 90;
  std::vector<StressPoint> points;
  for (int n = 0; n <= kPoints; ++n) {
    const double angle = std::acos(-1.0) * n / kPoints;
    points.push_back({circle.centre - circle.radius * std::cos(angle), circle.radius * std::sin(angle)});
  }
  return points;
}

results::ExperimentChart locus_chart(const ShearedPowder& one, const SeedResults& seed) {
  const auto strengths = strengths_of(seed, one.test);
  const YieldLocus locus = continuum::yield_locus_through(strengths);
  const StressPoint steady = preshear_of(seed, one);
  const MohrCircle large = continuum::steady_circle(locus, steady);
  const double right = std::ceil(1e-3 * std::fmax(large.major(), kPreshearStress) + 0.2);
  results::ExperimentChart chart;
  chart.name = "yield_locus_" + one.test.name;
  chart.title = "Yield locus of " + one.test.name + " after pre-shear at 3 kPa";
  chart.subtitle = "Vaned head in a cell of " + std::to_string(one.test.filled.cell.bore) +
                   " d, spheres of one size, calibrated set (Kottlan 2018)";
  // The same scale along both axes, so that circles are circles.
  chart.x = {.label = "Normal stress [kPa]", .lower = 0, .upper = right};
  chart.y = {.label = "Shear stress [kPa]", .lower = 0, .upper = right * 0.62};
  chart.series.push_back(series_of("Strength", Role::points, strengths));
  chart.series.push_back(series_of("Pre-shear", Role::points, {steady}));
  const double end = 1e3 * right;
  chart.series.push_back(series_of("Yield locus", Role::predicted, {{0, locus.at(0)}, {end, locus.at(end)}}));
  chart.series.push_back(series_of("Mohr circle, steady flow", Role::predicted, upper_half(large)));
  if (locus.cohesion > 0)
    chart.series.push_back(series_of("Mohr circle, unconfined", Role::predicted,
                                     upper_half(continuum::unconfined_circle(locus))));
  std::vector<StressPoint> published;
  for (const double stress : one.test.stresses) published.push_back({stress, one.published.at(stress)});
  published.push_back({kPreshearStress, one.published_preshear});
  chart.series.push_back(series_of("Kottlan 2018, Tables 12 and 15", Role::published, published));
  return chart;
}

void add_displacement(results::ExperimentSeries& series, const ShearCurve& curve, const FilledCell& filled,
                      const Span& span, double before) {
  for (std::size_t k = 0; k < curve.time.size(); ++k) {
    if (curve.time[k] < span.start || curve.time[k] > span.end) continue;
    series.x.push_back(before + (curve.time[k] - span.start) / filled.seconds(1));
    series.y.push_back(1e-3 * curve.shear[k]);
  }
}

results::ExperimentChart shear_chart(const ShearedPowder& one, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "shear_" + one.test.name;
  chart.title = "Shear stress of " + one.test.name + " in pre-shear and shear";
  chart.subtitle = "Pre-shear at 3 kPa, then freed of torque, unloaded and sheared again (Kottlan 2018)";
  chart.x = {.label = "Displacement of the rim [d]"};
  chart.y = {.label = "Shear stress [kPa]"};
  double sheared = 0;
  for (const double stress : one.test.stresses) {
    const auto spans = shear_spans(seed, one.test, stress);
    if (!spans) continue;
    const ShearCurve curve = head_curve(seed, one.test, stress);
    if (sheared == 0) {
      results::ExperimentSeries first{.name = "pre-shear, 3 kPa", .role = Role::predicted, .x = {}, .y = {}};
      add_displacement(first, curve, one.test.filled, spans->preshear, 0);
      chart.series.push_back(std::move(first));
      sheared = (spans->preshear.end - spans->preshear.start) / one.test.filled.seconds(1);
    }
    results::ExperimentSeries series{
        .name = plain(1e-3 * stress) + " kPa", .role = Role::predicted, .x = {}, .y = {}};
    add_displacement(series, curve, one.test.filled, spans->shear, sheared);
    chart.series.push_back(std::move(series));
  }
  return chart;
}

bool has_all(const SeedResults& seed, const ShearedPowder& one) {
  for (const auto& run : one.test.run_names())
    if (!seed.has(run)) return false;
  return true;
}

}  // namespace

LabPlan plan_shear_tester(const LabSetting& setting) {
  const std::vector<ShearedPowder> all = powders(setting.size);
  LabPlan plan;
  std::vector<ShearTest> tests;
  for (const ShearedPowder& one : all) tests.push_back(one.test);
  plan.runs = runs_of(tests);
  for (const ShearedPowder& one : all) {
    add_published(plan, one);
    add_own(plan, one);
    add_speed_check(plan, one);
  }
  plan.quantities.push_back(above_the_locus(all));
  plan.charts = [all](const SeedResults& seed) {
    std::vector<results::ExperimentChart> charts;
    for (const ShearedPowder& one : all) {
      if (!has_all(seed, one)) continue;
      charts.push_back(locus_chart(one, seed));
      charts.push_back(shear_chart(one, seed));
    }
    return charts;
  };
  return plan;
}

}  // namespace diefill::process::laboratory
