#include "process/measure/figures/counted_grains.h"

#include "process/measure/powder_surface.h"

namespace diefill::process {

std::vector<std::size_t> counted_grains(const results::PowderState& powder,
                                        const results::GrainSolidFraction& fraction, bool only_cavity) {
  const std::vector<double> depth = depth_below_surface(powder);
  std::vector<std::size_t> grains;
  for (std::size_t k = 0; k < depth.size(); ++k) {
    if (fraction.open[k] != 0 || (only_cavity && fraction.in_cavity[k] == 0)) continue;
    if (depth[k] >= kSurfaceDepth * powder.grain_diameter) grains.push_back(k);
  }
  return grains;
}

}  // namespace diefill::process
