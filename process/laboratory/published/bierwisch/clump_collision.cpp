// Collapse of contact energy over grain size (Bierwisch 2009, section 3.1, Fig. 3.1, Table C.1). The scene
// lets a few grains of a dilute box hit each other; all its lengths and times are in proportion to the grain
// size.
#include <algorithm>
#include <cmath>
#include <limits>

#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kScales[] = {1, 2, 4};
constexpr double kReference = 4.7e-4;  // m, d of scale 1
constexpr double kCompared = 1e-3;     // s at scale 1, from the first velocities on
constexpr double kInterval = 5e-6;     // s at scale 1, of the scene's probe

struct Case {
  const char* id;
  const char* name;
  const char* held;  ///< key whose effect is held fixed; empty: all scaled
  double value;      ///< of that key at scale 1
  const char* unit;
};

constexpr Case kCases[] = {{"B01", "all scaled", "", 0, ""},
                           {"B02", "gamma_n fixed", "powder.damping_over_radius", 1e5, "Pa s/m"},
                           {"B03", "kappa_t fixed", "powder.tangential_over_radius", 1e6, "Pa"},
                           {"B04", "w fixed", "powder.work_of_adhesion", 0.01, "J/m^2"}};

std::string run_name(const Case& one, double scale) {
  return std::string(one.name) + ", d = " + plain(1e3 * kReference * scale) + " mm";
}

/// Coefficients are in proportion to the size, so one that is held is this much smaller over the radius.
LabRun clump_collision_run(const Case& one, double scale) {
  const auto length = [&](double millimetre) { return millimetres(1e-3 * millimetre * scale); };
  LabRun run{run_name(one, scale), "collision.toml", {}};
  std::string& set = run.changes.set;
  set += line("powder.grain_diameter", millimetres(kReference * scale));
  set += line("pour.from", '[' + length(-0.94) + ", " + length(-0.94) + ", " + length(2.82) + ']');
  set += line("pour.to", '[' + length(0.94) + ", " + length(0.94) + ", " + length(4.7) + ']');
  set += line("pour.fill_height", length(0.25));
  set += line("step.2.duration", with_unit(3 * scale, "ms"));
  set += line("probe.energy.interval", with_unit(1e6 * kInterval * scale, "us"));
  set += line("numerics.time_step", with_unit(0.25 * scale, "us"));
  set += line("numerics.periodic", "{ x = " + length(1.9) + ", y = " + length(1.9) + " }");
  if (*one.held != '\0') set += line(one.held, with_unit(one.value / scale, one.unit));
  return run;
}

/// Contact energy over the grains' solid volume (J/m^3) in steps of the probe, from the first velocities on.
std::vector<double> energy_density(const results::FillResult& result) {
  const auto& probe = result.probes.front();
  const auto grains = static_cast<double>(result.powder.position.size());
  const double volume = grains * result.powder.grain_solid_volume;
  constexpr std::size_t kKinetic = 1, kContacts = 3;
  std::vector<double> density;
  bool begun = false;
  for (std::size_t k = 0; k < probe.values.size(); k += probe.columns.size()) {
    begun = begun || probe.values[k + kKinetic] > 0;
    if (begun) density.push_back(probe.values[k + kContacts] / volume);
  }
  density.resize(std::min(density.size(), static_cast<std::size_t>(kCompared / kInterval)));
  return density;
}

/// Largest difference of two sizes from the smallest one, over the largest value.
double largest_difference(const SeedResults& seed, const Case& one) {
  const auto reference = energy_density(seed.of(run_name(one, 1)));
  double peak = 0, most = 0;
  for (const double value : reference) peak = std::max(peak, value);
  for (const double scale : {2.0, 4.0}) {
    const auto other = energy_density(seed.of(run_name(one, scale)));
    for (std::size_t k = 0; k < std::min(reference.size(), other.size()); ++k)
      most = std::max(most, std::abs(other[k] - reference[k]));
  }
  return peak > 0 ? most / peak : std::numeric_limits<double>::quiet_NaN();
}

results::ExperimentChart clump_collision_chart(const SeedResults& seed, const Case& one) {
  results::ExperimentChart chart;
  chart.name = "clump_collision_" + std::string(one.id);
  chart.title = "Contact energy of colliding grains: " + std::string(one.name);
  chart.subtitle = "Model D, 0.2 m/s standard deviation of velocities, no gravity";
  chart.x = {.label = "Time over grain size [s/m]"};
  chart.y = {.label = "Contact energy over solid volume [J/m3]"};
  chart.first_seed_only = true;
  for (const double scale : kScales) {
    if (!seed.has(run_name(one, scale))) continue;
    results::ExperimentSeries series{.name = "d = " + plain(1e3 * kReference * scale) + " mm",
                                     .role = results::ExperimentSeries::Role::predicted,
                                     .x = {},
                                     .y = energy_density(seed.of(run_name(one, scale)))};
    for (std::size_t k = 0; k < series.y.size(); ++k)
      series.x.push_back(static_cast<double>(k) * kInterval / kReference);
    chart.series.push_back(series);
  }
  return chart;
}

}  // namespace

LabPlan plan_clump_collision(const LabSetting&) {
  LabPlan plan;
  for (const Case& one : kCases) {
    LabQuantity quantity{.id = one.id, .quantity = "", .unit = "", .runs = {}, .value = {}};
    for (const double scale : kScales) {
      plan.runs.push_back(clump_collision_run(one, scale));
      quantity.runs.push_back(run_name(one, scale));
    }
    quantity.value = [&one](const SeedResults& seed) { return largest_difference(seed, one); };
    plan.quantities.push_back(quantity);
  }
  plan.charts = [](const SeedResults& seed) {
    std::vector<results::ExperimentChart> charts;
    for (const Case& one : kCases) charts.push_back(clump_collision_chart(seed, one));
    return charts;
  };
  return plan;
}

}  // namespace diefill::process::laboratory
