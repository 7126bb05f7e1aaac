#include "process/estimate/estimate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "process/continuum/air.h"
#include "process/estimate/filling.h"
#include "process/estimate/inflow.h"
#include "process/estimate/scene_numbers.h"
#include "process/estimate/work_of_steps.h"
#include "process/powder/material.h"
#include "process/run/suction.h"
#include "process/scene/powder_presets.h"

namespace diefill::process::estimate {

namespace {

/// kg/m^3, of the real particles.
double solid_density(const Scene& scene) {
  const double metal = preset_solid_density(scene.powder);
  if (metal > 0) return metal;
  const auto shape = mean_grain(scene);
  return shape.mass / shape.solid_volume;
}

void choose_particles(const Scene& scene, const EstimateOptions& options, PowderEstimate& powder) {
  constexpr double kPublished = 1e-4;  // m (Bierwisch 2009, section 4.1.3)
  if (options.particle_diameter) {
    powder.particle_diameter = options.particle_diameter;
    powder.particle_source = "as given";
  } else if (scene.suction) {
    powder.particle_diameter = scene.suction->particle_diameter;
    powder.particle_source = "from [suction]";
  } else if (preset_solid_density(scene.powder) > 0) {
    powder.particle_diameter = kPublished;
    powder.particle_source = "about that of ASC100.29 (Bierwisch 2009, section 4.1.3)";
  }
  powder.air_viscosity = scene.suction ? scene.suction->viscosity : continuum::kAirViscosity;
}

PowderEstimate powder_of(const Scene& scene, const Tooling& tooling, const EstimateOptions& options) {
  PowderEstimate powder;
  powder.solid_fraction = expected_solid_fraction(scene);
  powder.density_is_estimate = !(scene.powder.apparent_density > 0);
  powder.density = powder.density_is_estimate ? powder.solid_fraction * solid_density(scene)
                                              : scene.powder.apparent_density;
  const Eigen::Vector3d box = scene.pour.upper - scene.pour.lower;
  powder.in_shoe = powder.density * box.x() * box.y() * scene.pour.fill_height * (tooling.mirror ? 2 : 1);
  powder.name = scene.powder.label;
  for (const OtherPowder& other : scene.other_powders)
    powder.left_out += (powder.left_out.empty() ? "" : ", ") + other.powder.label;
  choose_particles(scene, options, powder);
  if (!powder.particle_diameter) return powder;
  powder.air_number =
      continuum::air_number(*powder.particle_diameter, solid_density(scene), powder.air_viscosity);
  // Of the real powder: as loosely as its apparent density says.
  const double fraction = std::min(0.74, powder.density / solid_density(scene));
  powder.carrying_flux = continuum::carrying_flux(permeability(*powder.particle_diameter, fraction),
                                                  powder.density, powder.air_viscosity, scene.gravity.norm());
  return powder;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The largest factor on the shoe's speed at which `offered` (falling with it) still reaches `wanted`;
/// nothing where even a hundredth of it is too fast, or speed does not matter.
template <class Offered>
std::optional<double> fastest(const Offered& offered, double wanted) {
  double slow = 0.01, fast = 100;
  if (offered(slow) < wanted || offered(fast) >= wanted) return std::nullopt;
  while (fast > 1.002 * slow) {
    const double middle = std::sqrt(slow * fast);
    (offered(middle) >= wanted ? slow : fast) = middle;
  }
  return slow;
}

/// What an estimate of one opening goes by.
struct EstimateInputs {
  const OpeningLayout& layout;
  const ShoePath& path;
  const InflowPowder& powder;
};

/// kg offered to opening `k` in its first `crossings` at `faster` times the speed.
double offered_at(const EstimateInputs& inputs, std::size_t k, std::size_t crossings, double faster) {
  const auto mass = inflow(inputs.layout, inputs.path, inputs.powder, faster)[k];
  return std::accumulate(mass.begin(), mass.begin() + static_cast<std::ptrdiff_t>(crossings), 0.0);
}

FillSpace space_of(const OpeningEstimate& opening) {
  return {opening.depth, opening.width};
}

/// kg in the cavity of what is offered to it.
double kept(const OpeningEstimate& opening, double offered) {
  if (!(opening.full_mass > 0)) return 0;
  const double height = offered / opening.full_mass * opening.depth;
  return filled_height(space_of(opening), height) / opening.depth * opening.full_mass;
}

void find_speeds(const EstimateInputs& inputs, std::size_t k, OpeningEstimate& opening) {
  if (!opening.is_cavity || !(inputs.path.speed > 0) || opening.offered.empty()) return;
  const double wanted =
      offered_for(space_of(opening), kFull * opening.depth) / opening.depth * opening.full_mass;
  const auto speed = [&](std::size_t crossings) -> std::optional<double> {
    const auto factor =
        fastest([&](double faster) { return offered_at(inputs, k, crossings, faster); }, wanted);
    if (!factor) return std::nullopt;
    return *factor * inputs.path.speed;
  };
  opening.speed_once = speed(1);
  opening.speed_all = opening.offered.size() > 1 ? speed(opening.offered.size()) : opening.speed_once;
  const double once = sum(opening.offered) / static_cast<double>(opening.offered.size());
  if (once > 0 && wanted / once <= kMaxCrossings)
    opening.crossings = std::max(1, static_cast<int>(std::ceil(wanted / once - 1e-9)));
}

/// Sets what is shared over the places of opening `k`: where the shoe is too fast, how long powder covers it.
void find_cover(const EstimateInputs& inputs, std::size_t k, OpeningEstimate& opening) {
  double area = 0, fast = 0;
  for (std::size_t n = 0; n < inputs.layout.places.size(); ++n) {
    const OpeningPatch& place = inputs.layout.places[n];
    if (place.opening != k || inputs.path.exposures[n].empty()) continue;
    const double seconds = inputs.path.exposures[n].front().seconds;
    const double effective = effective_width(place.width, inputs.powder);
    area += place.area;
    opening.filling_time += place.area * seconds;
    const double fresh = std::max(1.0, inputs.path.exposures[n].front().travel / std::max(1e-9, effective));
    if (!(effective > 0) ||
        seconds / fresh < continuum::kBurst * std::sqrt(effective / inputs.powder.gravity))
      fast += place.area;
  }
  if (!(area > 0)) return;
  opening.filling_time /= area;
  opening.too_fast = fast / area;
}

/// What stays in the opening after each crossing, and its range.
void fill(const KnownError& error, OpeningEstimate& opening) {
  const auto in = [&](double offered) { return opening.is_cavity ? kept(opening, offered) : offered; };
  double offered = 0;
  for (const double more : opening.offered) {
    offered += more;
    opening.mass.push_back(in(offered));
  }
  const double packing = opening.is_cavity ? error.packing : 0;
  opening.least_mass = in(offered / error.factor) * (1 - packing);
  opening.most_mass = in(offered * error.factor) * (1 + packing);
  if (!(opening.full_mass > 0)) return;
  opening.share = in(offered) / opening.full_mass;
  opening.least_share = in(offered / error.factor) / opening.full_mass;
  opening.most_share = in(offered * error.factor) / opening.full_mass;
}

OpeningEstimate opening_of(const EstimateInputs& inputs, std::size_t k, const PowderEstimate& powder,
                           const KnownError& error) {
  const FillOpening& layout = inputs.layout.openings[k];
  OpeningEstimate opening;
  opening.is_cavity = layout.is_cavity;
  opening.name = !layout.is_cavity ? "slit" : k == 0 ? "cavity" : "cavity " + std::to_string(k + 1);
  opening.volume = layout.volume;
  opening.area = layout.area;
  opening.depth = layout.area > 0 ? layout.volume / layout.area : 0;
  opening.width = layout.width;
  opening.effective_width = effective_width(layout.width, inputs.powder);
  opening.full_mass = powder.density * layout.volume;
  opening.offered = inflow(inputs.layout, inputs.path, inputs.powder)[k];
  fill(error, opening);
  find_speeds(inputs, k, opening);
  find_cover(inputs, k, opening);
  if (opening.effective_width > 0)
    opening.froude = inputs.path.speed / std::sqrt(inputs.powder.gravity * opening.effective_width);
  if (opening.is_cavity && powder.carrying_flux)
    opening.air_escapes = continuum::escape_time(opening.depth, *powder.carrying_flux);
  return opening;
}

/// m/s, at which powder runs through an opening of this width in the long run.
double running_speed(const InflowPowder& powder, double width) {
  if (!(width > 0)) return 0;
  const double x = std::min(powder.law.longest, 1e3);
  return continuum::rate_share(powder.law.numbers, x) * std::sqrt(powder.gravity * width);
}

SuctionEstimate suction_of(const FallingPunch& punch, const EstimateInputs& inputs,
                           const PowderEstimate& powder) {
  SuctionEstimate suction;
  suction.punch = punch;
  suction.volume_mass = powder.density * punch.area * punch.stroke;
  const double width = effective_width(inputs.layout.openings[punch.opening].width, inputs.powder);
  const double own = running_speed(inputs.powder, width);
  suction.by_weight = suction.volume_mass * std::min(1.0, own / punch.speed());
  if (!powder.carrying_flux) return suction;
  suction.with_air = suction.volume_mass *
                     continuum::suction_speed(own, punch.speed(), *powder.carrying_flux) / punch.speed();
  suction.pull = punch.speed() / *powder.carrying_flux;
  return suction;
}

/// What the openings say together.
Answer answer_of(const Estimate& estimate) {
  bool any = false, all_full = !estimate.starved;
  for (const OpeningEstimate& opening : estimate.openings) {
    if (!opening.is_cavity || opening.offered.empty()) continue;
    any = true;
    if (!(opening.effective_width > 0)) return Answer::open;
    if (opening.most_share < kFull) return Answer::too_fast;
    all_full = all_full && opening.least_share >= kFull;
  }
  if (!any) return Answer::nothing_moves;
  return all_full ? Answer::fills : Answer::open;
}

/// What runs in is at most what the shoe holds.
void share_out(Estimate& estimate) {
  double all = 0;
  for (const OpeningEstimate& opening : estimate.openings)
    if (!opening.mass.empty()) all += opening.mass.back();
  estimate.starved = all > estimate.powder.in_shoe * (1 + 1e-9);
  if (!estimate.starved) return;
  for (OpeningEstimate& opening : estimate.openings) {
    const double there = estimate.powder.in_shoe / all;
    for (double& mass : opening.mass) mass *= there;
    for (double* part :
         {&opening.share, &opening.least_share, &opening.most_share, &opening.least_mass, &opening.most_mass})
      *part *= there;
  }
}

}  // namespace

Estimate estimate(const Scene& given, const Tooling& tooling, const EstimateOptions& options) {
  const Scene scene = with_prepared_steps(given, tooling);
  Estimate found;
  found.powder = powder_of(scene, tooling, options);
  found.law = options.law ? *options.law : discharge_of(scene.powder);
  found.grain_diameter = scene.powder.grain_diameter;
  found.error = known_error(scene.powder.name, options.law.has_value() || !scene.other_powders.empty());
  OpeningLayout layout = find_openings(scene, tooling);
  found.path = shoe_path(scene, tooling, layout);
  const InflowPowder powder{found.law, found.powder.density, found.grain_diameter, scene.gravity.norm()};
  const EstimateInputs inputs{layout, found.path, powder};
  for (std::size_t k = 0; k < layout.openings.size(); ++k)
    if (layout.openings[k].area > 0)
      found.openings.push_back(opening_of(inputs, k, found.powder, found.error));
  share_out(found);
  for (const FallingPunch& punch : layout.punches)
    found.suctions.push_back(suction_of(punch, inputs, found.powder));
  found.cycle_time = cycle_time(scene);
  found.crossing_time = crossing_time(scene, found.path.tool);
  found.answer = answer_of(found);
  found.numbers = scene_numbers(scene, found);
  found.path.exposures.clear();
  return found;
}

}  // namespace diefill::process::estimate
