#include "process/machine/step_registry.h"

#include "process/machine/clear.h"
#include "process/machine/force_control.h"
#include "process/machine/free_motion.h"
#include "process/machine/move.h"
#include "process/machine/passage.h"
#include "process/machine/powder_change.h"
#include "process/machine/powder_inflow.h"
#include "process/machine/rotation.h"
#include "process/machine/rotational_oscillation.h"
#include "process/machine/settle.h"
#include "process/machine/table_motion.h"
#include "process/machine/vibration.h"
#include "process/machine/wait.h"

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
