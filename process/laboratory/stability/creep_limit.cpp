// Heaps of rolling spheres that keep creeping: without static rolling friction a slope never comes to rest.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "engine/simulation/simulation.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
namespace laws = engine::laws;

constexpr double kRadius = 6e-4, kModulus = 1e7, kFriction = 0.5;  // m, Pa: Table C.4, four times as large
constexpr int kWidth = 4;                                          // grains along y, periodic

/// Rolling resistance that is compared: Bierwisch's dynamic torque against a sphere's own spin (2009, Eq.
/// 2.11) with a tenth of the fitted coefficient and with the fitted one, and a spring.
enum class Rolling { none, weak_torque, torque, spring };

/// Model B of Table C.4.
engine::ContactParameters thesis_contact(double rolling_friction) {
  return {.reduced_modulus = kModulus,
          .damping = 1e6 * kRadius,
          .tangential = 1e6 * kRadius,
          .friction = kFriction,
          .rolling_friction = rolling_friction};
}

laws::LawParameters law_with_spring() {
  laws::LawParameters law;
  law.normal = laws::BierwischNormal::Parameters{.reduced_modulus = kModulus};
  law.damping = laws::BierwischDamping::Parameters{.damping = 1e6 * kRadius};
  law.friction = laws::CundallFriction::Parameters{.tangential = 1e6 * kRadius, .friction = kFriction};
  law.rolling = laws::Epsd2Rolling::Parameters{.rolling_friction = 0.25, .shear_modulus = 1e6};
  return law;
}

engine::SimulationSettings settings_of(Rolling rolling) {
  engine::SimulationSettings settings;
  const auto sphere = thesis_grain(ThesisGrain::sphere);
  settings.types = {{engine::model_b(kRadius, sphere.mass * std::pow(kRadius / sphere.sphere_radius, 3))}};
  settings.period[1] = 2.1 * kRadius * kWidth;
  settings.time_step = 6e-6;
  const double share = rolling == Rolling::torque ? 2.5 : rolling == Rolling::weak_torque ? 0.25 : 0;
  const laws::LawParameters law =
      rolling == Rolling::spring ? law_with_spring() : laws::bierwisch_law(thesis_contact(share * kRadius));
  settings.contact = engine::one_powder(law, law);
  return settings;
}

/// A wall across x = 0 that powder leans on, and a floor of spheres that nothing slides on.
std::vector<engine::WallBodySpec> box(double depth) {
  engine::WallBodySpec wall, floor;
  wall.name = "wall";
  wall.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}};
  floor.name = "floor";
  floor.sphere_radius = kRadius;
  const double step = depth / kWidth;
  for (int x = -1; x < 60; ++x)
    for (int y = -kWidth; y <= kWidth; ++y) floor.centres.emplace_back(x * step, y * step, -kRadius);
  return {wall, floor};
}

/// A column against the wall, twice as high as it is wide.
std::vector<engine::NewGrain> column(double depth, int wide) {
  std::vector<engine::NewGrain> grains;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-0.04, 0.04);
  const double step = depth / kWidth;
  for (int z = 0; z < 2 * wide; ++z)
    for (int y = 0; y < kWidth; ++y)
      for (int x = 0; x < wide; ++x) {
        engine::NewGrain grain;
        grain.position = Eigen::Vector3d((x + 0.55) * step, (y + 0.5) * step - 0.5 * depth, (z + 0.6) * step);
        grain.position += kRadius * Eigen::Vector3d(0, uniform(random), uniform(random));
        grains.push_back(grain);
      }
  return grains;
}

/// Time (s) and height of the centre of mass over its first (1) of a column that collapses into a heap.
ExperimentSeries height_of(Rolling rolling, const std::string& name, double duration, int wide) {
  const auto settings = settings_of(rolling);
  engine::Simulation simulation(settings, box(*settings.period[1]));
  simulation.add_grains(column(*settings.period[1], wide));
  const auto height = [&] {
    double sum = 0;
    for (const auto& place : simulation.grains().position) sum += place.z();
    return sum / static_cast<double>(simulation.grains().size());
  };
  ExperimentSeries curve{.name = name, .x = {}, .y = {}};
  const double first = height();
  for (double time = 0.02; time < 1.001 * duration; time *= std::sqrt(2)) {
    while (simulation.time() < time) simulation.step();
    curve.x.push_back(time);
    curve.y.push_back(height() / first);
  }
  return curve;
}

}  // namespace

void find_creep_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  const double duration = options.quick ? 2.6 : 5.2;  // s
  const int wide = options.quick ? 5 : 8;
  results::ExperimentChart chart;
  chart.name = "creep";
  chart.title = "Heaps of rolling spheres over time";
  chart.subtitle = "A column collapses against a wall; spheres of 1.2 mm, friction 0.5, rough floor";
  chart.note =
      "Torque: Bierwisch's dynamic one against each sphere's spin, at most what stops it in a step. Spring: "
      "EPSD2.";
  chart.x = {.label = "Time [s]", .logarithmic = true};
  chart.y = {.label = "Height of the centre of mass over its initial value"};
  const std::vector<std::pair<Rolling, std::string>> cases = {{Rolling::none, "no rolling resistance"},
                                                              {Rolling::weak_torque, "torque, 0.25 R"},
                                                              {Rolling::torque, "torque, 2.5 R (B1)"},
                                                              {Rolling::spring, "spring, coefficient 0.25"}};
  for (const auto& [rolling, name] : cases) {
    chart.series.push_back(height_of(rolling, name, duration, wide));
    const auto& heights = chart.series.back().y;
    // Doubling the time is two points.
    result.limits.push_back({"heap, " + name + ": height lost in the last doubling of time",
                             1 - heights.back() / heights[heights.size() - 3], std::nan(""), "1", ""});
    result.limits.push_back(
        {"heap, " + name + ": height that remains", heights.back(), std::nan(""), "1", ""});
  }
  result.charts = {chart};
}

}  // namespace diefill::process::laboratory
