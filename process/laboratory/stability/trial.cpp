#include "process/laboratory/stability/trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "engine/numerics/out_of_range.h"
#include "engine/observe/energy_balance.h"
#include "engine/simulation/simulation.h"

namespace diefill::process::laboratory {

double largest_that_holds(double lower, double upper, double precision,
                          const std::function<bool(double)>& holds) {
  if (!holds(lower)) return lower;
  if (holds(upper)) return upper;
  while (upper > lower * (1 + precision)) {
    const double middle = std::sqrt(lower * upper);
    (holds(middle) ? lower : upper) = middle;
  }
  return std::sqrt(lower * upper);
}

std::vector<double> logarithmic_range(double lower, double upper, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k)
    values.push_back(lower * std::pow(upper / lower, static_cast<double>(k) / (count - 1)));
  return values;
}

std::vector<double> linear_range(double lower, double upper, int count) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(lower + (upper - lower) * k / (count - 1));
  return values;
}

engine::GrainShape thesis_grain(ThesisGrain kind) {
  constexpr double kMass = 7.63e-8;
  if (kind == ThesisGrain::c) return engine::model_c(8.9e-5, kMass);
  if (kind == ThesisGrain::d) return engine::model_d(7.84e-5, kMass);
  return engine::model_a(1.5e-4, kMass);
}

engine::ContactParameters elastic_contact() {
  return {.reduced_modulus = 1e7};
}

engine::ContactLaws bierwisch_contact(const engine::ContactParameters& grains,
                                      const engine::ContactParameters& walls) {
  return engine::one_powder(engine::laws::bierwisch_law(grains), engine::laws::bierwisch_law(walls));
}

engine::WallBodySpec plates(double lower, double upper) {
  engine::WallBodySpec body;
  body.name = "plates";
  body.planes = {{Eigen::Vector3d(0, 0, lower), Eigen::Vector3d::UnitZ()},
                 {Eigen::Vector3d(0, 0, upper), -Eigen::Vector3d::UnitZ()}};
  return body;
}

engine::WallBodySpec floor_plate() {
  engine::WallBodySpec body;
  body.name = "floor";
  body.planes = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()}};
  return body;
}

double rayleigh_time(double radius, double density, double reduced_modulus) {
  constexpr double kPoisson = 0.3;
  const double young = reduced_modulus * (1 - kPoisson * kPoisson);
  return std::numbers::pi * radius / (0.8766 + 0.163 * kPoisson) *
         std::sqrt(2 * density * (1 + kPoisson) / young);
}

double collision_time(const engine::GrainShape& shape, const engine::ContactParameters& contact,
                      double speed) {
  const double spring = 2.0 / 3.0 * contact.reduced_modulus * std::sqrt(0.5 * shape.sphere_radius);
  const double mass = 0.5 * shape.mass;
  return 3.218 * std::pow(mass * mass / (spring * spring * speed), 0.2);
}

double spurious_energy(engine::Simulation& simulation, long steps, double scale) {
  constexpr long kSamples = 200;
  std::vector<double> gained;
  const long every = std::max(1L, steps / kSamples);
  try {
    for (long k = 1; k <= steps; ++k) {
      simulation.step();
      if (k % every != 0) continue;
      gained.push_back((engine::energy_of(simulation).total() - simulation.ledger().expected()) / scale);
      if (!(gained.back() < 1)) return std::numeric_limits<double>::infinity();
    }
  } catch (const engine::OutOfRange&) {
    return std::numeric_limits<double>::infinity();
  }
  const auto quarter = static_cast<std::ptrdiff_t>(gained.size() / 4);
  const auto mean = [&](std::ptrdiff_t first) {
    return std::accumulate(gained.begin() + first, gained.begin() + first + quarter, 0.0) /
           static_cast<double>(quarter);
  };
  return 2 * (mean(3 * quarter) - mean(quarter));
}

}  // namespace diefill::process::laboratory
