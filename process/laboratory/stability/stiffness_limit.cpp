// How soft grains may be: overlap and solid fraction of a settled bed against E~.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/numerics/out_of_range.h"
#include "engine/simulation/standard_gravity.h"
#include "process/laboratory/settled_bed.h"
#include "process/laboratory/stability/registry.h"
#include "process/laboratory/stability/trial.h"

namespace diefill::process::laboratory {

namespace {

using results::ExperimentSeries;
using Role = ExperimentSeries::Role;

constexpr double kHeight = 12e-3, kDiameter = 1.2e-3;  // m
constexpr double kFraction = 0.57, kCoordination = 5;  // of the bed in the estimate

/// Spheres of Table C.4 (Bierwisch 2009) four times as large, 12 mm deep in a periodic box.
BedSpec bed_of(double reduced_modulus) {
  BedSpec spec;
  spec.powder.model = GrainModel::A;
  spec.powder.sphere_radius = 1.5e-4;
  spec.powder.grain_diameter = kDiameter;
  spec.powder.reduced_modulus = reduced_modulus;
  spec.width = spec.depth = 6 * kDiameter;
  spec.fill_height = kHeight;
  spec.expected_fraction = kFraction;
  spec.wall_sphere_radius = 3e-4;
  return spec;
}

/// Pa, under the weight of the bed.
double pressure_at_the_bottom() {
  const auto sphere = thesis_grain(ThesisGrain::sphere);
  return sphere.mass / sphere.solid_volume * kFraction * engine::kStandardGravity * kHeight;
}

/// Mean h / d of Hertzian contacts that carry the weight: p = phi Z F / (pi d^2) (virial stress), so that h /
/// d = (3 pi p / (phi Z E~))^(2/3), with 3/5 for the mean over the height.
double overlap_of_weight(double reduced_modulus) {
  const double ratio =
      3 * std::numbers::pi * pressure_at_the_bottom() / (kFraction * kCoordination * reduced_modulus);
  return 0.6 * std::pow(ratio, 2.0 / 3.0);
}

}  // namespace

void find_stiffness_limit(const ExperimentOptions& options, results::ExperimentResult& result) {
  results::ExperimentChart overlap, fraction;
  overlap.name = "stiffness_overlap";
  overlap.title = "Mean overlap in a settled bed";
  overlap.subtitle = "Spheres of 1.2 mm, 12 mm deep";
  overlap.note = "Theory: Hertzian contacts that carry the bed's weight, phi = 0.57, Z = 5.";
  overlap.x = {.label = "Reduced modulus [Pa]", .logarithmic = true};
  overlap.y = {.label = "Mean overlap over diameter", .logarithmic = true};
  fraction.name = "stiffness_fraction";
  fraction.title = "Solid fraction of a settled bed";
  fraction.subtitle = overlap.subtitle;
  fraction.note = "Missing point: the run exceeded the valid range.";
  fraction.x = overlap.x;
  fraction.y = {.label = "Solid fraction"};
  ExperimentSeries deep{.name = "measured", .x = {}, .y = {}}, dense = deep;
  ExperimentSeries theory{.name = "theory", .role = Role::predicted, .x = {}, .y = {}};
  for (const double modulus : logarithmic_range(1e5, options.quick ? 1e8 : 1e9, options.quick ? 7 : 13)) {
    BedSpec spec = bed_of(modulus);
    spec.threads = options.threads;
    for (auto* curve : {&deep, &dense, &theory}) curve->x.push_back(modulus);
    theory.y.push_back(overlap_of_weight(modulus));
    try {
      const BedFigures figures = settle_bed(spec);
      deep.y.push_back(figures.mean_overlap);
      dense.y.push_back(figures.bulk_fraction);
    } catch (const engine::OutOfRange&) {
      deep.y.push_back(std::nan(""));
      dense.y.push_back(std::nan(""));
    }
  }
  for (std::size_t k = 0; k < deep.x.size(); k += deep.x.size() / 3) {
    char name[120];
    std::snprintf(name, sizeof name, "mean overlap over d at E~ = %.3g Pa", deep.x[k]);
    result.limits.push_back({name, deep.y[k], theory.y[k], "1", "contacts that carry the weight"});
    std::snprintf(name, sizeof name, "solid fraction at E~ = %.3g Pa", deep.x[k]);
    result.limits.push_back({name, dense.y[k], std::nan(""), "1", ""});
  }
  overlap.series = {deep, theory};
  fraction.series = {dense};
  result.charts = {overlap, fraction};
}

}  // namespace diefill::process::laboratory
