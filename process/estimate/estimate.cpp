#include "process/estimate/estimate.h"

#include <algorithm>

#include "process/estimate/cohesion.h"
#include "process/estimate/no_estimate.h"
#include "process/estimate/opening_estimate.h"
#include "process/estimate/openings/outlet.h"
#include "process/estimate/powder_estimate.h"
#include "process/estimate/statements/answer.h"
#include "process/estimate/statements/scene_numbers.h"
#include "process/estimate/statements/wording.h"
#include "process/estimate/suction_estimate.h"
#include "process/estimate/work_of_steps.h"

namespace diefill::process::estimate {

namespace {

/// "cavity", of several "cavity 2"; "slit"
std::string name_of_opening(const OpeningLayout& layout, std::size_t k) {
  if (!layout.openings[k].is_cavity) return "slit";
  return layout.openings.size() == 1 ? "cavity" : "cavity " + std::to_string(k + 1);
}

bool only_shakes(const Scene& scene) {
  bool shakes = false;
  for (const auto& step : scene.steps) {
    if (step->tools().empty()) continue;
    if (!step->stays()) return false;
    shakes = true;
  }
  return shakes;
}

/// kg that run into all openings in crossing `n`.
double run_in(const Estimate& estimate, std::size_t n) {
  double mass = 0;
  for (const OpeningEstimate& opening : estimate.openings)
    mass += opening.mass[n] - (n > 0 ? opening.mass[n - 1] : 0);
  return mass;
}

/// Cuts the sum of one bound of all openings down to what the shoe holds.
void cap_bound(double OpeningEstimate::*bound, double available, Estimate& estimate) {
  double all = 0;
  for (const OpeningEstimate& opening : estimate.openings) all += opening.*bound;
  if (all <= available) return;
  for (OpeningEstimate& opening : estimate.openings) opening.*bound *= available / all;
}

/// What runs in is at most what the shoe holds: the crossing in which that ends is the last one that fills.
void limit_by_powder_in_shoe(Estimate& estimate) {
  const double available = estimate.powder.in_shoe + estimate.powder.let_in;
  std::vector<double> parts;  // of what runs in, by crossing
  double used = 0;
  for (std::size_t n = 0; n < estimate.path.crossings; ++n) {
    const double mass = estimate.openings.empty() ? 0 : run_in(estimate, n);
    parts.push_back(mass > available - used ? (available - used) / mass : 1);
    used += parts.back() * mass;
    estimate.powder_limited = estimate.powder_limited || parts.back() < 1 - 1e-9;
  }
  if (!estimate.powder_limited) return;
  for (OpeningEstimate& opening : estimate.openings) {
    double before = 0, kept = 0;
    for (std::size_t n = 0; n < opening.mass.size(); ++n) {
      kept += parts[n] * (opening.mass[n] - before);
      before = opening.mass[n];
      opening.mass[n] = kept;
    }
  }
  cap_bound(&OpeningEstimate::least_mass, available, estimate);
  cap_bound(&OpeningEstimate::most_mass, available, estimate);
  for (OpeningEstimate& opening : estimate.openings) {
    if (!(opening.full_mass > 0)) continue;
    opening.share = std::min(opening.share, opening.mass.back() / opening.full_mass);
    opening.least_share = std::min(opening.least_share, opening.least_mass / opening.full_mass);
    opening.most_share = std::min(opening.most_share, opening.most_mass / opening.full_mass);
  }
}

}  // namespace

Estimate estimate(const Scene& given, const Tooling& tooling, const EstimateOptions& options) {
  const Scene scene = with_prepared_steps(given, tooling);
  Estimate found;
  found.powder = powder_estimate(scene, tooling, options);
  found.law = options.law ? *options.law : discharge_of(scene.powder);
  found.grain_diameter = scene.powder.grain_diameter;
  found.error = known_error(scene, options.law.has_value());
  found.cycle_time = cycle_time(scene);
  if (is_not_estimated(scene, tooling, found)) return found;
  found.bond = bond_number(scene);
  OpeningLayout layout = find_openings(scene, tooling);
  found.path = shoe_path(scene, tooling, layout);
  const InflowPowder powder{found.law, found.powder.density, found.grain_diameter, scene.gravity.norm()};
  const EstimateInputs inputs{layout, found.path, powder};
  for (std::size_t k = 0; k < layout.openings.size(); ++k) {
    const FillOpening& opening = layout.openings[k];
    const std::string name = name_of_opening(layout, k);
    if (opening.area > 0) {
      found.openings.push_back(opening_estimate(inputs, k, found.powder, found.error));
      found.openings.back().name = name;
    } else if (opening.is_cavity) {
      found.unseen.push_back(name + place_text(opening.centre));
    }
  }
  limit_by_powder_in_shoe(found);
  for (std::size_t k = 0; k < layout.punches.size(); ++k)
    found.suctions.push_back(suction_estimate(scene, inputs, k, found.powder));
  found.outlet = outlet_of(scene, tooling, powder, found.powder.in_shoe);
  found.only_shaken = only_shakes(scene);
  found.crossing = crossing_of(scene, found.path.tool);
  find_answer(found);
  found.numbers = scene_numbers(scene, found);
  found.path.exposures.clear();
  return found;
}

}  // namespace diefill::process::estimate
