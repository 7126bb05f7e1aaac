#include "process/machine/step_registry.h"

#include "process/machine/passage.h"
#include "process/machine/settle.h"
#include "process/machine/wait.h"

namespace diefill::process {

const Choices<StepFactory>& step_kinds() {
  static const Choices<StepFactory> kinds = {
      {"passage", read_passage},
      {"settle", read_settle},
      {"wait", read_wait},
  };
  return kinds;
}

}  // namespace diefill::process
