#include "process/measure/figures/real_mass.h"

#include <cmath>
#include <limits>

#include "process/measure/cavity_position.h"
#include "process/measure/figures/counted_grains.h"
#include "process/measure/figures/enough_grains.h"
#include "process/measure/measure.h"
#include "process/measure/weights.h"
#include "process/results/no_value.h"

namespace diefill::process {
namespace {

std::string no_bed(const PowderBed& bed) {
  return "no powder outside the cavity to compare with: " +
         too_few_text(bed.grains, "two diameters below the surface there", kMinGrains);
}

double solid_in_cavity(const results::FillResult& result) {
  double volume = 0;
  for (std::size_t k = 0; k < result.solid_fraction.in_cavity.size(); ++k)
    if (result.solid_fraction.in_cavity[k] != 0) volume += result.powder.solid_volume_of(k);
  return volume;
}

}  // namespace

PowderBed powder_bed(const results::FillResult& result, const std::vector<results::CavityState>& cavities) {
  const auto& powder = result.powder;
  std::vector<std::size_t> grains = counted_grains(powder, result.solid_fraction, false);
  std::erase_if(grains, [&](std::size_t k) {
    for (const auto& cavity : cavities)
      if (lies_in_cavity(cavity, powder.position[k])) return true;
    return false;
  });
  PowderBed bed{std::numeric_limits<double>::quiet_NaN(), grains.size()};
  if (grains.size() < kMinGrains) return bed;
  double cells = 0;
  for (const std::size_t k : grains) cells += result.solid_fraction.cell_volume[k];
  bed.solid_fraction = solid_volume(powder, grains) / cells;
  return bed;
}

void add_real_mass(results::FillResult& result, const RealPowder& powder, const PowderBed& bed) {
  const double volume = result.cavity.volume;
  if (!(volume > 0)) return;
  auto& figures = result.figures;
  const double solid = solid_in_cavity(result);
  figures["fill_density_kg_m3"] = filled_mass(result.powder, result.solid_fraction) / volume;
  figures["cavity_solid_fraction"] = solid / volume;
  figures["solid_density_kg_m3"] = powder.solid_density;
  const bool stands = std::isfinite(bed.solid_fraction);
  const bool weighed = powder.apparent_density > 0;
  const double apparent = weighed  ? powder.apparent_density
                          : stands ? bed.solid_fraction * powder.solid_density
                                   : std::numeric_limits<double>::quiet_NaN();
  if (std::isfinite(apparent)) {
    figures["apparent_density_kg_m3"] = apparent;
    figures["apparent_density_is_estimate"] = weighed ? 0 : 1;
    figures["full_die_mass_kg"] = apparent * volume;
  } else {
    results::set_no_value(result, "apparent_density_kg_m3", "unknown: set powder.apparent_density");
  }
  if (stands) {
    const double ratio = solid / volume / bed.solid_fraction;
    figures["fill_ratio"] = ratio;
    figures["expected_fill_density_kg_m3"] = ratio * apparent;
    figures["expected_mass_kg"] = ratio * apparent * volume;
  } else {
    results::set_no_value(result, "fill_ratio", no_bed(bed));
    if (powder.solid_density > 0) figures["estimated_mass_kg"] = solid * powder.solid_density;
  }
}

}  // namespace diefill::process
