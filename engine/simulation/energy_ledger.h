// The energy accounts of a run: what went in and out must balance what is there.
#pragma once

namespace diefill::engine {

/// Work done on the powder since the start, in J, by everything that is not gravity or a normal spring.
/// Negative: taken out.
struct Ledger {
  double viscous_work = 0;     ///< normal damping
  double tangential_work = 0;  ///< friction; what tangential springs hold is counted as taken out
  double drag_work = 0;        ///< air
  double rolling_work = 0;     ///< rolling friction
  double wall_work = 0;        ///< moving tools
  double sleep_work = 0;       ///< what grains still moved with that fell asleep
  /// Energy of grains when they were added, less that of grains when they left; a grain that comes round a
  /// periodic border against gravity counts as lifted.
  double added_energy = 0;

  /// Energy (J) that the powder should hold now.
  double expected() const {
    return added_energy + viscous_work + tangential_work + drag_work + rolling_work + wall_work + sleep_work;
  }
};

/// Energy of the powder at one instant, J.
struct Energy {
  double translation = 0, rotation = 0;  ///< kinetic
  double height = 0;                     ///< gravitational, zero at the origin
  double contacts = 0;                   ///< in normal springs
  double kinetic() const { return translation + rotation; }
  double total() const { return translation + rotation + height + contacts; }
};

}  // namespace diefill::engine
