// How a narrow ring fills in time (Bierwisch 2009, section 6.4): one passage at 0.09 m/s, looked at 100 + 150
// n ms after the shoe's front has reached azimuth 0 (assumed), and 50 ms before each; and how deep later
// passages at 0.2 m/s move the powder. Coarse: d = 1.88 mm in a ring of 4.46 mm; the other sizes: 0.94 mm in
// one of 3.15 mm.
#include "process/laboratory/published/bierwisch/ring_motion.h"
#include "process/laboratory/published/bierwisch/ring_scene.h"
#include "process/laboratory/published/experiments.h"

namespace diefill::process::laboratory {
namespace {

constexpr const char *kRun = "one passage at 0.09 m per s", *kSix = "six passages at 0.2 m per s";
constexpr double kInner = 8e-3, kDepth = 20e-3;                   // m, of the ring
constexpr double kFront = 19.4e-3;                                // m, where the shoe's inside begins
constexpr double kSpeed = 0.09, kAcceleration = 10;               // m/s, m/s^2
constexpr double kFirst = 0.100, kNext = 0.150, kBefore = 0.050;  // s
constexpr int kInstants = 4;
constexpr double kFull = 0.95;  // of the mass in the end

RingSpace ring_of(const LabSetting& setting) {
  return {kInner, kInner + (setting.size == LabSize::coarse ? 4.462e-3 : 3.146e-3), kDepth};
}

std::string snapshot(const std::string& name, const std::string& when) {
  return "[[snapshot]]\nname = \"" + name + "\"\nwhen = { " + when + " }\n";
}

std::string at(int n) {
  return "instant_" + std::to_string(n);
}

std::string before(int n) {
  return "before_instant_" + std::to_string(n);
}

LabRun watched_passage(const LabSetting& setting) {
  LabRun run = ring_passages(setting, kRun, "\"0.09 m/s\"", 1);
  run.changes.set += line("step.1.name", "\"passage\"");
  const double arrives = (kFront - ring_of(setting).outer) / kSpeed + kSpeed / (2 * kAcceleration);
  for (int n = 0; n < kInstants; ++n) {
    const double time = arrives + kFirst + n * kNext;
    const auto delayed = [](double seconds) {
      return "with = \"passage\", delay = " + with_unit(1e3 * seconds, "ms");
    };
    run.changes.set += snapshot(before(n), delayed(time - kBefore)) + snapshot(at(n), delayed(time));
  }
  return run;
}

std::string step(const std::string& name, const std::string& keys) {
  return "[[step]]\nname = \"" + name + "\"\n" + keys;
}

/// Three times back and forth; a rest of 50 ms and a snapshot after each pair.
LabRun six_passages(const LabSetting& setting) {
  LabRun run{kSix, kRingScene, {ring_keys(setting) + line("numerics.most_sheared", "0.02"), {}}};
  std::string snapshots;
  for (int pair = 1; pair <= 3; ++pair) {
    const std::string number = std::to_string(pair);
    run.changes.set += step("pair " + number,
                            "kind = \"passage\"\ntool = \"shoe\"\ndirection = \"-x\"\n"
                            "velocity = \"0.2 m/s\"\npassages = 2\n"
                            "acceleration = \"10 m/s^2\"\nclearance = \"2 mm\"\n");
    run.changes.set += step("rest " + number, "kind = \"wait\"\nduration = \"50 ms\"\n");
    snapshots += snapshot("after_pair_" + number, "after = \"rest " + number + '"');
  }
  run.changes.set += snapshots;
  return run;
}

const results::PowderState& after_pair(const SeedResults& seed, int pair) {
  return seed.at(kSix, "after_pair_" + std::to_string(pair)).powder;
}

std::string passages_of(int pair) {
  return "passages " + std::to_string(2 * pair + 1) + " and " + std::to_string(2 * pair + 2);
}

LabQuantity of_run(const char* run, const std::string& id, const std::string& quantity,
                   const std::function<double(const SeedResults&)>& value) {
  return {.id = id, .quantity = quantity, .unit = quantity.empty() ? "" : "1", .runs = {run}, .value = value};
}

double filled_share(const SeedResults& seed, int n) {
  return filled_volume(seed.at(kRun, at(n)).powder) / filled_volume(seed.of(kRun).powder);
}

double near_start(const SeedResults& seed, int n) {
  const auto& powder = seed.at(kRun, at(n)).powder;
  return filled_volume(powder, true) / filled_volume(powder);
}

/// ms after the shoe's front has reached the ring.
double time_of_instant(int n) {
  return 1e3 * (kFirst + n * kNext);
}

results::ExperimentChart ring_transient_chart(const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "ring_transient";
  chart.title = "Filling of a narrow ring in time";
  chart.subtitle =
      "One passage at 0.09 m/s; published: first near azimuth 0, nearly full at the third instant";
  chart.x = {.label = "Time after the shoe has reached the ring [ms]", .lower = 0};
  chart.y = {.label = "Share [-]", .lower = 0, .upper = 1};
  if (!seed.has(kRun)) return chart;
  results::ExperimentSeries filled{.name = "filled, of the mass in the end", .x = {}, .y = {}},
      near{.name = "within 90 deg of azimuth 0", .x = {}, .y = {}};
  for (int n = 0; n < kInstants; ++n) {
    for (auto* series : {&filled, &near}) series->x.push_back(time_of_instant(n));
    filled.y.push_back(filled_share(seed, n));
    near.y.push_back(near_start(seed, n));
  }
  chart.series = {filled, near};
  return chart;
}

results::ExperimentChart ring_displacement_chart(const RingSpace& ring, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "ring_displacement";
  chart.title = "How far later passages move the powder";
  chart.subtitle = "Six passages at 0.2 m/s; published: down to about a third of the depth";
  chart.x = {.label = "Depth below the upper edge [mm]", .lower = 0, .upper = 1e3 * ring.depth};
  chart.y = {.label = "Share of grains moved by half a grain size [-]", .lower = 0, .upper = 1};
  if (!seed.has(kSix)) return chart;
  for (const int pair : {1, 2}) {
    const auto& before = after_pair(seed, pair);
    const auto moved = moved_shares(before, after_pair(seed, pair + 1), ring);
    results::ExperimentSeries series{.name = passages_of(pair), .x = {}, .y = moved};
    for (std::size_t layer = 0; layer < moved.size(); ++layer)
      series.x.push_back(1e3 * (static_cast<double>(layer) + 0.5) * before.grain_diameter);
    chart.series.push_back(series);
  }
  const double third = 1e3 * ring.depth / 3;
  chart.series.push_back({.name = "a third of the depth",
                          .role = results::ExperimentSeries::Role::predicted,
                          .x = {third, third},
                          .y = {0, 1}});
  return chart;
}

}  // namespace

LabPlan plan_ring_transient(const LabSetting& setting) {
  const RingSpace ring = ring_of(setting);
  LabPlan plan;
  plan.runs = {watched_passage(setting)};
  const auto near_surface = [ring](int n) {
    return [ring, n](const SeedResults& seed) {
      return change_near_surface(seed.at(kRun, before(n)).powder, seed.at(kRun, at(n)).powder, ring);
    };
  };
  plan.quantities.push_back(of_run(kRun, "M09", "", near_surface(1)));
  plan.quantities.push_back(of_run(kRun, "M10", "", [](const SeedResults& seed) {
    return 0.5 * (filled_share(seed, 2) >= kFull) + 0.5 * (near_start(seed, 0) > 0.5);
  }));
  for (int n = 0; n < kInstants; ++n) {
    const std::string when = ", " + plain(time_of_instant(n)) + " ms";
    const auto add = [&](const std::string& what, const std::function<double(const SeedResults&)>& value) {
      plan.quantities.push_back(of_run(kRun, what + when, what + when, value));
    };
    add("filled share", [n](const SeedResults& seed) { return filled_share(seed, n); });
    add("share within 90 deg of azimuth 0", [n](const SeedResults& seed) { return near_start(seed, n); });
    add("change near the surface", near_surface(n));
  }
  plan.charts = [](const SeedResults& seed) { return std::vector{ring_transient_chart(seed)}; };
  return plan;
}

LabPlan plan_ring_displacement(const LabSetting& setting) {
  const RingSpace ring = ring_of(setting);
  LabPlan plan;
  plan.runs = {six_passages(setting)};
  plan.quantities.push_back(of_run(kSix, "M11", "", [ring](const SeedResults& seed) {
    return depth_of_motion(after_pair(seed, 1), after_pair(seed, 2), ring) / ring.depth;
  }));
  for (const int pair : {1, 2})
    plan.quantities.push_back(of_run(kSix, "motion " + std::to_string(pair),
                                     "mean way over d, " + passages_of(pair),
                                     [pair](const SeedResults& seed) {
                                       return mean_motion(after_pair(seed, pair), after_pair(seed, pair + 1));
                                     }));
  plan.charts = [ring](const SeedResults& seed) { return std::vector{ring_displacement_chart(ring, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
