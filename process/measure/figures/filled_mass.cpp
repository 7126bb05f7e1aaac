#include "process/measure/measure.h"
#include "process/measure/weights.h"

namespace diefill::process {

double filled_mass(const results::PowderState& powder, const results::GrainSolidFraction& fraction) {
  std::vector<std::size_t> filled;
  for (std::size_t k = 0; k < fraction.in_cavity.size(); ++k)
    if (fraction.in_cavity[k] != 0) filled.push_back(k);
  return mass(powder, filled);
}

}  // namespace diefill::process
