// Laws, grains, turning, flow above a slit and discharge against exact results (Bierwisch 2009):
// numbers that need no bed of powder.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/laws/contact_law.h"
#include "engine/powder/clump_union.h"
#include "engine/powder/rigid_motion.h"
#include "engine/powder/sphere_volume.h"
#include "process/continuum/kinematic_model.h"
#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/stability/pair_collision.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kModulus = 1e7;  // Pa, E~ of all powders of the source

LabQuantity number(const std::string& id, const std::function<double()>& value) {
  return {.id = id, .quantity = "", .unit = "", .runs = {}, .value = [value](const SeedResults&) {
            return value();
          }};
}

struct Deepest {
  double overlap, force;  ///< m, N
};

/// Where Hertz' force with cohesion is smallest (Bierwisch 2009, Eq. 2.5), by golden section.
Deepest strongest_pull() {
  constexpr double kAdhesion = 0.01, kRadius = 3.92e-5, kPrecision = 1e-7;
  const engine::laws::HertzianCohesion cohesion(kAdhesion, kModulus, kRadius);
  const engine::laws::Hertz elastic(kModulus, kRadius);
  const auto force = [&](double overlap) {
    return elastic.force(overlap, std::sqrt(overlap)) + cohesion.force(overlap, std::sqrt(overlap));
  };
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double low = 0, high = 1e-6;
  while (high - low > kPrecision * high) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    (force(left) < force(right) ? high : low) = force(left) < force(right) ? right : left;
  }
  return {0.5 * (low + high), force(0.5 * (low + high))};
}

/// A head-on collision of two grains, one sphere of each in contact.
struct HeadOn {
  const char* id;
  ThesisGrain grain;
  double damping_over_radius;  ///< Pa s/m
  double adhesion;             ///< J/m^2
  double speed;                ///< m/s
};

constexpr HeadOn kCollisions[] = {
    {"V04", ThesisGrain::sphere, 1e5, 0, 0.2},    {"V05", ThesisGrain::sphere, 1e6, 0, 0.2},
    {"V06", ThesisGrain::sphere, 1e6, 0.01, 0.2}, {"V07", ThesisGrain::d, 1e5, 0, 0.2},
    {"V08", ThesisGrain::d, 1e6, 0, 0.2},         {"V09", ThesisGrain::d, 1e6, 0.01, 0.2},
    {"V10", ThesisGrain::d, 1e6, 0.15, 0.2},      {"V11", ThesisGrain::d, 1e6, 0.15, 0.5}};

PairCollision collide(const HeadOn& collision, double time_step) {
  constexpr long kLongest = 200000;
  engine::SimulationSettings settings;
  settings.types = {{thesis_grain(collision.grain)}};
  engine::ContactParameters contact = elastic_contact();
  contact.damping = collision.damping_over_radius * settings.shape().sphere_radius;
  contact.work_of_adhesion = collision.adhesion;
  settings.contact = bierwisch_contact(contact, contact);
  settings.gravity.setZero();
  settings.time_step = time_step;
  return meet_head_on(settings, collision.speed, 0, kLongest);
}

/// s; Hertz' force alone.
double duration_of_collision() {
  return collide({"", ThesisGrain::sphere, 0, 0, 0.2}, 1e-8).time;
}

/// Volume of model C's six spheres over that of one, integrated.
double union_of_model_c() {
  std::vector<engine::ClumpSphere> spheres;
  for (const auto& offset : engine::model_c(1, 1).sphere_offsets) spheres.push_back({offset, 1.0});
  return engine::grain_of_union(spheres, 1).solid_volume / engine::sphere_volume(1);
}

/// I / (m R^2).
double inertia_number(const engine::GrainShape& shape) {
  return shape.inertia.x() / (shape.mass * shape.sphere_radius * shape.sphere_radius);
}

/// Largest difference of the matrix of no rotation from the identity (Bierwisch 2009, Eq. 2.13).
double difference_from_identity() {
  return (engine::rotation_matrix(engine::Quaternion(1, 0, 0, 0)) - Eigen::Matrix3d::Identity())
      .cwiseAbs()
      .maxCoeff();
}

/// |q|^2 - 1 after a step, the largest of many orientations, spins and rates (Bierwisch 2009, Eq. 2.20).
double norm_after_step() {
  constexpr int kDraws = 1000;
  constexpr double kSpin = 1e3, kRate = 1e6, kStep = 2e-6;  // rad/s, rad/s^2, s
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  const auto vector = [&](double size) {
    return Eigen::Vector3d(size * normal(random), size * normal(random), size * normal(random));
  };
  double largest = 0;
  for (int k = 0; k < kDraws; ++k) {
    const engine::Quaternion start =
        engine::Quaternion(normal(random), normal(random), normal(random), normal(random)).normalized();
    const auto next = engine::advance_orientation(start, vector(kSpin), vector(kRate), kStep);
    const double off = next.squaredNorm() - 1;
    if (std::abs(off) > std::abs(largest)) largest = off;
  }
  return largest;
}

/// m/s at `height` (m) above the middle of a slit of 15 mm in a hopper of 45 mm, B = 1.8 mm, 0.4 m/s in the
/// slit (Bierwisch 2009, appendix B); grid as published.
double speed_above_slit(double height) {
  constexpr double kSlit = 0.015, kSpacing = 0.25e-3;
  const continuum::HopperGrid grid{.width = 0.045, .height = 0.05, .columns = 180, .rows = 200};
  std::vector<double> opening(static_cast<std::size_t>(grid.columns), 0.0);
  for (int column = 0; column < grid.columns; ++column)
    if (std::abs(grid.x(column)) < kSlit / 2) opening[static_cast<std::size_t>(column)] = -0.4;
  const auto flow = continuum::solve_kinematic(grid, opening, continuum::constant_length(1.8e-3));
  const int row = static_cast<int>(std::lround(height / kSpacing)), middle = grid.columns / 2;
  return 0.5 * (flow.vertical_at(middle - 1, row) + flow.vertical_at(middle, row));
}

/// m/s half-way up, columns of the coarsest of three grids, on one refined `times` times; solid fraction and
/// profile in the slit are smooth.
std::vector<double> smooth_flow(int times) {
  constexpr int kColumns = 32, kRows = 32;
  const continuum::HopperGrid grid{
      .width = 0.04, .height = 0.04, .columns = kColumns * times, .rows = kRows * times};
  const double wave = 2 * std::numbers::pi;
  std::vector<double> opening, fraction;
  for (int column = 0; column < grid.columns; ++column)
    opening.push_back(-0.2 - 0.1 * std::cos(wave * grid.x(column) / grid.width));
  for (int row = 0; row <= grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      fraction.push_back(0.3 + 0.02 * std::cos(wave * grid.x(column) / grid.width) *
                                   std::sin(wave * row / (2.0 * grid.rows)));
  const auto flow = continuum::solve_kinematic(grid, opening, continuum::LengthOfFraction(), fraction);
  std::vector<double> means(kColumns, 0.0);
  for (int column = 0; column < grid.columns; ++column)
    means[static_cast<std::size_t>(column / times)] += flow.vertical_at(column, grid.rows / 2) / times;
  return means;
}

/// Order in which the compressible model's error falls with the mesh, from three meshes.
double order_of_flow() {
  const auto coarse = smooth_flow(1), middle = smooth_flow(2), fine = smooth_flow(4);
  double first = 0, second = 0;
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    first += std::abs(coarse[k] - middle[k]);
    second += std::abs(middle[k] - fine[k]);
  }
  return std::log2(first / second);
}

/// A point of the measured curve of discharge.
struct Discharge {
  const char* id;
  double width, speed;  ///< m, m/s
};

constexpr Discharge kDischarges[] = {{"V20", 0.006, 0.1}, {"V21", 0.006, 0.15}, {"V22", 0.006, 0.18},
                                     {"V23", 0.006, 0.4}, {"V24", 0.006, 0.6},  {"V25", 0.006, 0.8},
                                     {"V26", 0.010, 0.1}, {"V27", 0.010, 0.18}, {"V28", 0.010, 0.4},
                                     {"V29", 0.010, 0.8}};

}  // namespace

LabPlan plan_closed_forms(const LabSetting&) {
  LabPlan plan;
  const auto add = [&](const std::string& id, const std::function<double()>& value) {
    plan.quantities.push_back(number(id, value));
  };
  add("V01", [] { return strongest_pull().force; });
  add("V02", [] { return strongest_pull().overlap; });
  add("V03", duration_of_collision);
  for (const HeadOn& collision : kCollisions)
    add(collision.id, [&collision] { return collide(collision, 1e-7).rebound / collision.speed; });
  add("V12", union_of_model_c);
  add("V13", [] { return inertia_number(thesis_grain(ThesisGrain::c)); });
  add("V14", [] { return inertia_number(thesis_grain(ThesisGrain::d)); });
  add("V15", [] { return speed_above_slit(0.015); });
  add("V16", [] { return speed_above_slit(0.045); });
  add("V17", order_of_flow);
  add("V18", difference_from_identity);
  add("V19", norm_after_step);
  for (const Discharge& point : kDischarges)
    add(point.id, [&point] { return 1e6 * measured_area(point.width, point.speed); });
  return plan;
}

}  // namespace diefill::process::laboratory
