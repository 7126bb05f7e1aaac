// Flow near a slit of 10 mm while the shoe passes (Bierwisch 2009, section 4.1.8, Figs. 4.12 and 4.13): how
// fast grains go down at ground level, the slow powder behind the slit, and how even the flow is away from
// it. Means over grains at five instants of the middle half of the passage, at rest with the slit.
#include <algorithm>
#include <cmath>
#include <map>

#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/results/none.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kWidth = 0.010, kInside = 0.032;  // m, slit, shoe
constexpr double kSlow = 0.18, kFast = 0.4;        // m/s
constexpr int kInstants = 5;

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

/// Snapshots while the shoe's middle half is over the slit.
std::string instants_of(const SlitPassage& passage) {
  std::string set = "[[snapshot]]\nname = \"settled\"\n";
  for (int k = 0; k < kInstants; ++k) {
    const double way = kInside * (-0.25 + 0.5 * k / (kInstants - 1.0));
    set += "[[snapshot]]\nname = \"" + instant_name(k) + "\"\nwhen = { with = \"passage\", delay = \"" +
           plain(1e3 * time_over_slit(passage, way)) + " ms\" }\n";
  }
  return set;
}

/// A grain near the slit: place (m), speed over that of the shoe.
struct Passing {
  double x, z, speed, volume;
};

std::vector<Passing> passing_grains(const SeedResults& seed, const std::string& run, double speed) {
  std::vector<Passing> all;
  for (int k = 0; k < kInstants; ++k) {
    const auto& powder = seed.at(run, instant_name(k)).powder;
    for (std::size_t n = 0; n < powder.position.size(); ++n)
      all.push_back({powder.position[n][0], powder.position[n][2], powder.velocity[n].norm() / speed,
                     powder.grain_solid_volume});
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

/// mm^2 of solid in powder slower than 0.6 of the shoe, within two grains above the ground and a slit's width
/// behind the slit, to where the shoe goes.
double slow_area(const SeedResults& seed, const std::string& run, double half_width) {
  constexpr double kSlower = 0.6;
  const double height = 2 * diameter(seed, run);
  double volume = 0;
  for (const Passing& grain : passing_grains(seed, run, kSlow))
    if (grain.x < -half_width && grain.x > -3 * half_width && grain.z > 0 && grain.z < height &&
        grain.speed < kSlower)
      volume += grain.volume;
  return 1e6 * volume / kInstants / seed.of(run).powder.period[1];
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
    return area(true) / area(false);
  });
  add("L03", kFast, [setting, any](const SeedResults& seed) {
    return mean_over_models(seed, setting, kFast, unevenness, any);
  });
  plan.charts = [setting](const SeedResults& seed) { return std::vector{slit_fields_chart(setting, seed)}; };
  return plan;
}

}  // namespace diefill::process::laboratory
