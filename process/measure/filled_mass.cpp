#include "process/measure/measure.h"

namespace diefill::process {

double filled_mass(const results::PowderState& powder, const results::GrainSolidFraction& fraction) {
  double grains = 0;
  for (const auto in_cavity : fraction.in_cavity) grains += in_cavity;
  return grains * powder.grain_mass;
}

}  // namespace diefill::process
