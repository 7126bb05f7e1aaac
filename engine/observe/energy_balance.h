// The energy of the powder, compared with the work done on it.
#pragma once

#include "engine/simulation/energy_ledger.h"

namespace diefill::engine {

class Simulation;

/// Energy of the powder now, summed in a fixed order.
Energy energy_of(const Simulation& simulation);

/// Difference between the energy there is and the energy the ledger expects, over the energy exchanged so
/// far.
double energy_balance_error(const Simulation& simulation);

}  // namespace diefill::engine
