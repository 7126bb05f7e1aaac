#include "engine/observe/energy_balance.h"

#include <cmath>

#include "engine/simulation/powder_energy.h"
#include "engine/simulation/simulation.h"

namespace diefill::engine {

Energy energy_of(const Simulation& simulation) {
  return energy_of(simulation.state());
}

double energy_balance_error(const Simulation& simulation) {
  const Energy now = energy_of(simulation);
  const Ledger& ledger = simulation.ledger();
  const double turned_over = std::abs(ledger.viscous_work) + std::abs(ledger.tangential_work) +
                             std::abs(ledger.drag_work) + std::abs(ledger.rolling_work) +
                             std::abs(ledger.wall_work) + now.kinetic() + std::abs(now.contacts);
  return turned_over == 0 ? 0 : (now.total() - ledger.expected()) / turned_over;  // NaN stays NaN
}

}  // namespace diefill::engine
