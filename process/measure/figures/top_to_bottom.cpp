#include "process/measure/figures/counted_grains.h"
#include "process/measure/figures/figures.h"
#include "process/measure/powder_surface.h"
#include "process/measure/weights.h"

namespace diefill::process {

void top_to_bottom(const results::FillResult& result, Figures& figures) {
  const auto& powder = result.powder;
  const std::vector<double> depth = depth_below_surface(powder);
  std::vector<std::size_t> grains[3];
  double cells[3] = {0, 0, 0};
  for (const std::size_t k : counted_grains(powder, result.solid_fraction, true)) {
    const double height = powder.position[k].z() - result.cavity.lower_corner.z();
    const double relative = height / (height + depth[k]);
    const int third = relative < 1.0 / 3 ? 0 : relative < 2.0 / 3 ? 1 : 2;
    grains[third].push_back(k);
    cells[third] += result.solid_fraction.cell_volume[k];
  }
  // Without a grain in a third: 0 / 0, which is the NaN that says so.
  figures["solid_fraction_top_minus_bottom"] =
      solid_volume(powder, grains[2]) / cells[2] - solid_volume(powder, grains[0]) / cells[0];
}

}  // namespace diefill::process
