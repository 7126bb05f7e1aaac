#include "process/machine/step_registry.h"

#include "process/machine/actions/clear.h"
#include "process/machine/actions/powder_change.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/machine/actions/settle.h"
#include "process/machine/actions/wait.h"
#include "process/machine/force_control.h"
#include "process/machine/free_motion.h"
#include "process/machine/motions/move.h"
#include "process/machine/motions/passage.h"
#include "process/machine/motions/rotation.h"
#include "process/machine/motions/rotational_oscillation.h"
#include "process/machine/motions/table_motion.h"
#include "process/machine/motions/vibration.h"

namespace diefill::process {

const Choices<StepFactory>& step_kinds() {
  static const Choices<StepFactory> kinds = {
      {"passage", read_passage},     {"settle", read_settle},
      {"wait", read_wait},           {"move", read_move},
      {"vibration", read_vibration}, {"rotational oscillation", read_rotational_oscillation},
      {"rotation", read_rotation},   {"table", read_table_motion},
      {"piston", read_piston},       {"rotor", read_rotor},
      {"inflow", read_inflow},       {"clear", read_clear},
      {"change", read_change},       {"free motion", read_free_motion},
  };
  return kinds;
}

}  // namespace diefill::process
