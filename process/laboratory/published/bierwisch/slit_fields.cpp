// Flow near a slit of 10 mm while the shoe passes (Bierwisch 2009, section 4.1.8, Figs. 4.12 and 4.13): how
// fast grains go down at ground level, the slow powder behind the slit, and how even speed and solid fraction
// are away from it. Means over five instants of the middle half of the passage, at rest with the slit.
#include <algorithm>
#include <cmath>
#include <map>

#include "process/laboratory/published/bierwisch/passage_fields.h"
#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/results/none.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kWidth = 0.010, kInside = 0.032;  // m, slit, shoe
constexpr double kSlow = 0.18, kFast = 0.4;        // m/s
constexpr int kInstants = 5;
constexpr double kSlowBehind = 0.010,
                 kSlowHigh = 0.004,  // m, box behind the slit in which the slow zone is sought
    kSlowCell = 2.5e-4;              // m, between its points

struct Model {
  const char* name;
  const char* preset;
  bool clump;  ///< C1 and D1
};

constexpr Model kModels[] = {{"A1", "ASC100.29 A1", false},
                             {"B1", "ASC100.29 B1", false},
                             {"C1", "ASC100.29 C1", true},
                             {"D1", "ASC100.29 D1", true}};

std::string run_name(const Model& model, double speed) {
  return std::string(model.name) + ", " + plain(speed) + " m/s";
}

std::string instant_name(int number) {
  return "passing " + std::to_string(number);
}

/// Snapshots at rest and while the shoe's middle half is over the slit; they replace those of the scene file.
std::string instants_of(const SlitPassage& passage) {
  std::string set = "[[snapshot]]\nname = \"settled\"\nwhen = { after = \"settling\" }\n";
  for (int k = 0; k < kInstants; ++k) {
    const double way = kInside * (-0.25 + 0.5 * k / (kInstants - 1.0));
    set += "[[snapshot]]\nname = \"" + instant_name(k) + "\"\nwhen = { with = \"passage\", delay = \"" +
           plain(1e3 * time_over_slit(passage, way)) + " ms\" }\n";
  }
  return set;
}

/// A grain near the slit: place (m), speed over that of the shoe.
struct Passing {
  double x, z, speed;
};

std::vector<Passing> passing_grains(const SeedResults& seed, const std::string& run, double speed) {
  std::vector<Passing> all;
  for (int k = 0; k < kInstants; ++k) {
    const auto& powder = seed.at(run, instant_name(k)).powder;
    for (std::size_t n = 0; n < powder.position.size(); ++n)
      all.push_back({powder.position[n][0], powder.position[n][2], powder.velocity[n].norm() / speed});
  }
  return all;
}

double diameter(const SeedResults& seed, const std::string& run) {
  return seed.of(run).powder.grain_diameter;
}

/// Speed over that of the shoe of the grains in the slit, half a grain about ground level.
double outflow_speed(const SeedResults& seed, const std::string& run, double half_width) {
  const double reach = 0.5 * diameter(seed, run);
  double sum = 0, count = 0;
  for (const Passing& grain : passing_grains(seed, run, kSlow))
    if (std::abs(grain.x) < half_width && std::abs(grain.z) < reach) sum += grain.speed, ++count;
  return count > 0 ? sum / count : kNone;
}

std::vector<std::string> instant_names() {
  std::vector<std::string> names;
  for (int k = 0; k < kInstants; ++k) names.push_back(instant_name(k));
  return names;
}

/// mm^2, where powder on the ground is slower than 0.6 of the shoe, behind the slit, to where the shoe goes.
double slow_area(const SeedResults& seed, const std::string& run, double half_width) {
  constexpr double kSlower = 0.6;
  const PassageFields fields = passage_fields(seed, run, instant_names(), kSlow);
  double cells = 0;
  for (double x = -half_width - 0.5 * kSlowCell; x > -half_width - kSlowBehind; x -= kSlowCell)
    for (double z = 0.5 * kSlowCell; z < kSlowHigh; z += kSlowCell)
      cells += fields.speed.at({x, 0, z}) < kSlower ? 1 : 0;  // no powder, no value: NaN
  return 1e6 * cells * kSlowCell * kSlowCell;
}

/// Standard deviation of a field among points 2 d apart within the shoe, farther than 1.5 slits from the
/// slit.
double unevenness_of(const GaussianField& field, double step, double half_width) {
  double sum = 0, squares = 0, count = 0;
  for (double x = -0.25 * kInside; x <= 0.25 * kInside; x += step)
    for (double z = step; z < 0.024; z += step) {
      const double value = field.at({x, 0, z});
      if (std::hypot(x, z) < 3 * half_width || !std::isfinite(value)) continue;
      sum += value, squares += value * value, ++count;
    }
  return count > 1 ? std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count))) : kNone;
}

double unevenness_of_fraction(const SeedResults& seed, const std::string& run, double half_width) {
  const PassageFields fields = passage_fields(seed, run, instant_names(), kFast);
  return unevenness_of(fields.fraction, 2 * diameter(seed, run), half_width);
}

/// Standard deviation of the speed over that of the shoe among cells of 2 d, farther than 1.5 slits from the
/// slit.
double unevenness(const SeedResults& seed, const std::string& run, double half_width) {
  constexpr double kMin = 10;  // grains in a cell
  const double cell = 2 * diameter(seed, run);
  std::map<std::pair<long, long>, std::pair<double, double>> cells;
  for (const Passing& grain : passing_grains(seed, run, kFast)) {
    if (grain.z < 0 || std::hypot(grain.x, grain.z) < 3 * half_width) continue;
    auto& [sum, count] = cells[{std::lround(grain.x / cell), std::lround(grain.z / cell)}];
    sum += grain.speed;
    ++count;
  }
  double sum = 0, squares = 0, count = 0;
  for (const auto& [place, of] : cells) {
    if (of.second < kMin) continue;
    const double mean = of.first / of.second;
    sum += mean, squares += mean * mean, ++count;
  }
  return count > 1 ? std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count))) : kNone;
}

using Measure = double (*)(const SeedResults&, const std::string&, double);

/// Mean of a measure over the models for which `wanted` holds.
double mean_over_models(const SeedResults& seed, const LabSetting& setting, double speed, Measure measure,
                        const std::function<bool(const Model&)>& wanted) {
  double sum = 0, count = 0;
  for (const Model& model : kModels) {
    if (!wanted(model)) continue;
    const LabPowder powder = lab_powder(setting, model.preset, setting.scale());
    sum += measure(seed, run_name(model, speed), 0.5 * adjusted_slit(kWidth, powder));
    ++count;
  }
  return sum / count;
}

/// Speed over that of the shoe across the slit, of grains half a grain about ground level.
results::ExperimentSeries outflow_series(const SeedResults& seed, const Model& model, double half_width) {
  constexpr int kParts = 8;  // of the slit
  const std::string run = run_name(model, kSlow);
  const double reach = 0.5 * diameter(seed, run);
  std::vector<double> sum(kParts), count(kParts);
  for (const Passing& grain : passing_grains(seed, run, kSlow)) {
    const double place = kParts * 0.5 * (1 + grain.x / half_width);
    if (place < 0 || place >= kParts || std::abs(grain.z) >= reach) continue;
    sum[static_cast<std::size_t>(place)] += grain.speed;
    ++count[static_cast<std::size_t>(place)];
  }
  results::ExperimentSeries series{.name = model.name, .x = {}, .y = {}};
  for (std::size_t part = 0; part < kParts; ++part) {
    series.x.push_back((static_cast<double>(part) + 0.5) / kParts - 0.5);
    series.y.push_back(count[part] > 0 ? sum[part] / count[part] : kNone);
  }
  return series;
}

/// Speed or solid fraction along the ground, a grain above it, over the distance from the slit's middle.
results::ExperimentChart ground_chart(const SeedResults& seed, bool of_speed) {
  constexpr double kReach = 0.020, kStep = 5e-4;  // m
  results::ExperimentChart chart;
  chart.name = of_speed ? "ground_speed" : "ground_fraction";
  chart.title =
      of_speed ? "Speed of the powder above the plate" : "Solid fraction of the powder above the plate";
  chart.subtitle =
      "One grain above the plate, shoe at 0.18 m/s to the left, Gaussian average of five instants";
  chart.x = {.label = "Distance from the middle of the slit [mm]"};
  chart.y = {.label = of_speed ? "Speed over that of the shoe [-]" : "Solid fraction over that at rest [-]",
             .lower = 0};
  for (const Model& model : kModels) {
    const std::string run = run_name(model, kSlow);
    if (!seed.has(run)) continue;
    const PassageFields fields = passage_fields(seed, run, instant_names(), kSlow);
    results::ExperimentSeries series{.name = model.name, .x = {}, .y = {}};
    for (double x = -kReach; x < kReach + 0.5 * kStep; x += kStep) {
      series.x.push_back(1e3 * x);
      series.y.push_back((of_speed ? fields.speed : fields.fraction).at({x, 0, diameter(seed, run)}));
    }
    chart.series.push_back(series);
  }
  return chart;
}

results::ExperimentChart slit_fields_chart(const LabSetting& setting, const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "slit_fields";
  chart.title = "Speed of the grains in the slit";
  chart.subtitle = "At ground level, shoe at 0.18 m/s, five instants";
  chart.x = {.label = "Place across the slit over its width [-]", .lower = -0.5, .upper = 0.5};
  chart.y = {.label = "Speed over that of the shoe [-]", .lower = 0};
  for (const Model& model : kModels) {
    if (!seed.has(run_name(model, kSlow))) continue;
    const LabPowder powder = lab_powder(setting, model.preset, setting.scale());
    chart.series.push_back(outflow_series(seed, model, 0.5 * adjusted_slit(kWidth, powder)));
  }
  return chart;
}

std::vector<std::string> runs_at(double speed) {
  std::vector<std::string> runs;
  for (const Model& model : kModels) runs.push_back(run_name(model, speed));
  return runs;
}

}  // namespace

LabPlan plan_slit_fields(const LabSetting& setting) {
  LabPlan plan;
  for (const Model& model : kModels) {
    const LabPowder powder = lab_powder(setting, model.preset, setting.scale());
    for (const double speed : {kSlow, kFast}) {
      const SlitPassage passage{.width = adjusted_slit(kWidth, powder), .speed = speed};
      LabRun run{run_name(model, speed), "slit.toml", slit_changes(setting, powder, passage)};
      run.changes.set += instants_of(passage);
      plan.runs.push_back(run);
    }
  }
  const auto any = [](const Model&) { return true; };
  const auto add = [&](const char* id, double speed, const std::function<double(const SeedResults&)>& value) {
    plan.quantities.push_back({.id = id, .quantity = "", .unit = "", .runs = runs_at(speed), .value = value});
  };
  add("L01", kSlow, [setting, any](const SeedResults& seed) {
    return mean_over_models(seed, setting, kSlow, outflow_speed, any);
  });
  add("L02", kSlow, [setting](const SeedResults& seed) {
    const auto area = [&](bool clumps) {
      return mean_over_models(seed, setting, kSlow, slow_area,
                              [clumps](const Model& model) { return model.clump == clumps; });
    };
    return area(true) / std::max(area(false), 1e6 * kSlowCell * kSlowCell);  // of none, that of a cell
  });
  add("L03", kFast, [setting, any](const SeedResults& seed) {
    return mean_over_models(seed, setting, kFast, unevenness, any);
  });
  plan.quantities.push_back({.id = "scatter of the solid fraction",
                             .quantity = "scatter of f/f_m over cells of 2 d, beyond 1.5 D",
                             .unit = "1",
                             .runs = runs_at(kFast),
                             .value = [setting, any](const SeedResults& seed) {
                               return mean_over_models(seed, setting, kFast, unevenness_of_fraction, any);
                             }});
  plan.charts = [setting](const SeedResults& seed) {
    return std::vector{slit_fields_chart(setting, seed), ground_chart(seed, true), ground_chart(seed, false)};
  };
  return plan;
}

}  // namespace diefill::process::laboratory
