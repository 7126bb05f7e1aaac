// Powder that settles on wall spheres and on the surface itself: how loosely it lies near the wall, and what
// either kind of wall costs.
#include <cmath>
#include <ctime>

#include "process/laboratory/settled_bed.h"
#include "process/laboratory/walls/level_wall.h"
#include "process/laboratory/walls/registry.h"

namespace diefill::process::laboratory {

namespace {

struct Ground {
  std::string name;
  bool mesh = false;
  double radius = 1.5e-4, spacing = 1.6;
};

/// The default powder (Bierwisch 2009, Table C.4: model D, mu = 0.25), four times as large.
BedSpec bed_on(const Ground& ground, const ExperimentOptions& options, std::uint64_t seed) {
  BedSpec spec;
  spec.powder.grain_diameter *= 4;
  spec.width = spec.depth = (options.quick ? 4.5 : 6) * spec.powder.grain_diameter;
  spec.fill_height = options.quick ? 8e-3 : 12e-3;
  spec.wall_sphere_radius = ground.radius;
  spec.ground_spacing = ground.spacing;
  spec.mesh_ground = ground.mesh;
  spec.seed = seed;
  spec.threads = options.threads;
  return spec;
}

/// Mean over seeds of beds on one ground, and how they scatter.
struct Beds {
  std::vector<double> height, fraction;  ///< z / d; share of the plane that is solid
  double bulk = 0, near_wall = 0;        ///< solid fractions, in all and up to one grain size from the wall
  double bulk_scatter = 0, near_wall_scatter = 0;  ///< standard deviation over seeds
  double seconds = 0;                              ///< of processor time for a million sphere-steps
};

double mean_below(const BedFigures& bed, double height) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < bed.height.size() && bed.height[k] < height; ++k, ++count)
    sum += bed.fraction[k];
  return sum / count;
}

double scatter(double sum, double squares, double count) {
  return std::sqrt(std::max(0.0, squares - sum * sum / count) / (count - 1));
}

Beds settle_on(const Ground& ground, const ExperimentOptions& options) {
  const std::uint64_t seeds = options.quick ? 2 : 3;
  const auto count = static_cast<double>(seeds);
  Beds beds;
  double bulk_squares = 0, near_squares = 0, sphere_steps = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const std::clock_t begin = std::clock();
    const BedFigures bed = settle_bed(bed_on(ground, options, seed));
    beds.seconds += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    sphere_steps += static_cast<double>(bed.sphere_steps);
    const double near = mean_below(bed, 1);
    beds.bulk += bed.bulk_fraction;
    beds.near_wall += near;
    bulk_squares += bed.bulk_fraction * bed.bulk_fraction;
    near_squares += near * near;
    // Beds differ in height: what all have is drawn.
    if (beds.height.empty() || bed.height.size() < beds.height.size()) beds.height = bed.height;
    beds.fraction.resize(seed == 1 ? bed.fraction.size() : beds.height.size());
    for (std::size_t k = 0; k < beds.fraction.size(); ++k) beds.fraction[k] += bed.fraction[k] / count;
  }
  beds.bulk_scatter = scatter(beds.bulk, bulk_squares, count);
  beds.near_wall_scatter = scatter(beds.near_wall, near_squares, count);
  beds.bulk /= count;
  beds.near_wall /= count;
  beds.seconds *= 1e6 / sphere_steps;
  return beds;
}

void add_limits(const std::string& ground, const Beds& beds, const Beds& mesh,
                results::ExperimentResult& result) {
  const auto add = [&](const std::string& what, double measured, double on_mesh, const char* unit) {
    result.limits.push_back({what + ", " + ground, measured, on_mesh, unit, "mesh"});
  };
  add("solid fraction in all", beds.bulk, mesh.bulk, "1");
  add("its standard deviation over seeds", beds.bulk_scatter, mesh.bulk_scatter, "1");
  add("solid fraction up to d from the wall", beds.near_wall, mesh.near_wall, "1");
  add("its standard deviation over seeds near the wall", beds.near_wall_scatter, mesh.near_wall_scatter, "1");
  add("processor time for a million sphere-steps", beds.seconds, mesh.seconds, "s");
}

}  // namespace

void compare_beds(const ExperimentOptions& options, results::ExperimentResult& result) {
  results::ExperimentChart chart;
  chart.name = "bed_near_wall";
  chart.title = "Powder settled on wall spheres and on the surface itself";
  chart.subtitle = "Model D, d = 1.88 mm, R = 0.31 mm, mean over seeds";
  chart.note = "Share of the horizontal plane inside grains.";
  chart.x = {.label = "Height above the wall over d", .upper = 3};
  chart.y = {.label = "Solid fraction", .lower = 0};
  const Beds mesh = settle_on({.name = "mesh", .mesh = true}, options);
  chart.series.push_back({.name = "mesh", .x = mesh.height, .y = mesh.fraction});
  for (const Ground& ground : {Ground{.name = "R_w = 0.15 mm, spacing 1.6"},
                               Ground{.name = "R_w = 0.15 mm, spacing 2", .spacing = 2},
                               Ground{.name = "R_w = 0.3 mm, spacing 1.6", .radius = 3e-4}}) {
    const Beds beds = settle_on(ground, options);
    chart.series.push_back({.name = ground.name, .x = beds.height, .y = beds.fraction});
    add_limits(ground.name, beds, mesh, result);
  }
  result.charts.push_back(chart);
}

}  // namespace diefill::process::laboratory
