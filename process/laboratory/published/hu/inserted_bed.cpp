#include "process/laboratory/published/hu/inserted_bed.h"

#include <algorithm>
#include <cmath>

#include "process/laboratory/published/bed_window.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kPouredShare = 0.01;  // of the powder, so that the scene has a bed to begin with
constexpr double kPouredFraction = 0.3;
constexpr const char* kBed = "bed";  // the snapshot

}  // namespace

Insertion of_width(Insertion insertion, double width) {
  const double ratio = width / insertion.width;
  insertion.region *= ratio;
  insertion.mass *= ratio * ratio;
  insertion.width = width;
  return insertion;
}

LabRun run_of(const InsertedBed& bed) {
  const Insertion& in = bed.insertion;
  const double half = 0.5 * in.width, region = 0.5 * in.region, area = in.width * in.width;
  const double poured = kPouredShare * in.mass, entering = in.mass - poured;
  const double depth = poured / (area * kCohesiveDensity * kPouredFraction);
  LabRun run{bed.name, "sticky_bed.toml", {cohesive_lines(bed.spheres), {}}};
  std::string& set = run.changes.set;
  if (bed.spheres.sizes.size() > 1) run.changes.without.emplace_back("powder.grain_diameter");
  const double box = std::max(depth, 1.5 * largest_diameter(bed.spheres));
  set += line("pour.from", point_in_millimetres(-half, -half, 0));
  set += line("pour.to", point_in_millimetres(half, half, box));
  set += line("pour.fill_height", millimetres(depth));
  set += line("pour.solid_fraction", plain(kPouredFraction));
  set += line("step.insert.from", point_in_millimetres(-region, -region, in.from));
  set += line("step.insert.to", point_in_millimetres(region, region, in.to));
  set += line("step.insert.mass", with_unit(entering, "kg"));
  if (in.time > 0)
    set += line("step.insert.rate", with_unit(entering / in.time, "kg/s"));
  else
    run.changes.without.emplace_back("step.insert.rate");
  set += line("step.rest.duration", with_unit(in.rest, "s"));
  set +=
      line("numerics.periodic", "{ x = " + millimetres(in.width) + ", y = " + millimetres(in.width) + " }");
  return run;
}

InsertedBedFigures figures_of(const SeedResults& seed, const std::string& run, double from, double to) {
  const results::PowderState& powder = seed.at(run, kBed).powder;
  return {kCohesiveDensity * fraction_between(powder, from, to), contacts_between(powder, from, to),
          top_of(powder), kinetic_energy_over_weight(powder)};
}

LabQuantity own_figure(const std::string& run, const std::string& what, const std::string& unit, double from,
                       double to, double InsertedBedFigures::*figure) {
  return {.id = what + ", " + run,
          .quantity = what + ", " + run,
          .unit = unit,
          .runs = {run},
          .value = [=](const SeedResults& seed) { return figures_of(seed, run, from, to).*figure; }};
}

double percent_apart(double value, double reference) {
  return 100 * std::abs(value / reference - 1);
}

}  // namespace diefill::process::laboratory
