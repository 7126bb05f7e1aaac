#include "process/laboratory/published/sawing/viscosity.h"

#include <array>
#include <cmath>

#include "engine/fluid/fluid_figures.h"
#include "process/laboratory/published/sawing/fluid_bytes.h"
#include "process/laboratory/published/sawing/sawing_json.h"

namespace diefill::process::laboratory::sawing {
namespace {

constexpr int kParts = 10, kReportInterval = 20;

/// Mean, and standard deviation of it.
struct Estimate {
  double mean = 0, deviation = 0;
};

Estimate estimate(const std::array<double, kParts>& parts) {
  double sum = 0, squares = 0;
  for (const double part : parts) sum += part, squares += part * part;
  const double mean = sum / kParts;
  return {mean, std::sqrt(std::max(0.0, squares / kParts - mean * mean) / (kParts - 1))};
}

engine::FluidSettings settings_of(const ShearedSlurry& slurry, std::uint64_t seed) {
  engine::FluidSettings settings;
  settings.period = {slurry.edge, slurry.edge, slurry.edge};
  settings.shear_rate = slurry.rate;
  settings.law.grip = slurry.grip;
  settings.time_step = slurry.time_step;
  settings.seed = seed;
  return settings;
}

/// What has been summed up over the sampled steps.
struct ShearedSums {
  std::array<double, kParts> viscosity{};
  double pressure = 0, temperature = 0;
};

/// One run.
class Shearing {
 public:
  Shearing(const ShearedSlurry& slurry, std::uint64_t seed)
      : slurry_(slurry), simulation_(settings_of(slurry, seed)) {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * slurry.edge);
    const SlurrySpace space{-half, half, simulation_.settings().period, std::pow(slurry.edge, 3),
                            [](const Eigen::Vector3d&) { return 1e9; }};
    solids_ = fill(space, {.solids = slurry.solids, .density = slurry.density}, seed, simulation_).solids;
  }

  ShearedFigures run(CustomRunWatch& watch) {
    if (!watch.begun().empty()) restore(watch.begun());
    const int all = slurry_.settling + kParts * (slurry_.sampled / kParts);
    for (int k = static_cast<int>(simulation_.state().step) + 1; k <= all; ++k) {
      simulation_.step();
      if (k > slurry_.settling) sample(k - slurry_.settling - 1);
      if (k % kReportInterval == 0) watch.report(static_cast<double>(k) / all, [&] { return state(); });
    }
    const Estimate all_parts = estimate(sums_.viscosity);
    return {all_parts.mean,      sums_.temperature, sums_.pressure,
            all_parts.deviation, solids_,           static_cast<double>(simulation_.particles().size())};
  }

 private:
  void sample(int k) {
    const int part_steps = slurry_.sampled / kParts;
    const Eigen::Matrix3d pressure = engine::fluid_pressure(simulation_);
    const double share = 1.0 / part_steps;
    if (slurry_.rate != 0)
      sums_.viscosity[static_cast<std::size_t>(k / part_steps)] -=
          0.5 * share * (pressure(0, 1) + pressure(1, 0)) / slurry_.rate;
    sums_.pressure += share / kParts * pressure.trace() / 3;
    sums_.temperature += share / kParts * engine::fluid_temperature(simulation_);
  }

  std::string state() const {
    ByteWriter writer;
    const engine::FluidSnapshot fluid = simulation_.snapshot();
    transfer_fluid(writer, fluid);
    writer(sums_);
    return writer.bytes();
  }

  void restore(const std::string& bytes) {
    ByteReader reader(bytes);
    engine::FluidSnapshot fluid;
    transfer_fluid(reader, fluid);
    reader(sums_);
    simulation_.restore(fluid);
  }

  ShearedSlurry slurry_;
  engine::FluidSimulation simulation_;
  double solids_ = 0;
  ShearedSums sums_;
};

/// Watch of a run that is not monitored.
class Unwatched final : public CustomRunWatch {
 public:
  const std::filesystem::path& folder() const override { return folder_; }
  const std::string& begun() const override { return begun_; }
  void report(double, const std::function<std::string()>&) override {}

 private:
  std::filesystem::path folder_;
  std::string begun_;
};

}  // namespace

std::string settings_text(const ShearedSlurry& slurry) {
  nlohmann::ordered_json json = fluid_settings(settings_of(slurry, 0));
  json.update({{"edge", slurry.edge},
               {"rate", slurry.rate},
               {"solids", slurry.solids},
               {"filled_density", slurry.density},
               {"sizes", SlurryMixture().sizes},
               {"settling", slurry.settling},
               {"sampled", slurry.sampled}});
  return json.dump();
}

double work_of(const ShearedSlurry& slurry) {
  const double density = slurry.solids / std::pow(kSpacing, 3) + (1 - slurry.solids) * slurry.density;
  return density * std::pow(slurry.edge, 3) * (slurry.settling + slurry.sampled);
}

ShearedFigures measure(const ShearedSlurry& slurry, std::uint64_t seed, CustomRunWatch& watch) {
  return Shearing(slurry, seed).run(watch);
}

ShearedFigures measure(const ShearedSlurry& slurry, std::uint64_t seed) {
  Unwatched watch;
  return measure(slurry, seed, watch);
}

}  // namespace diefill::process::laboratory::sawing
