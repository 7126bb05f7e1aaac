#include "app/commands/ranks/step_engine.h"

namespace diefill::app {

process::StepEngine*& step_engine() {
  static process::StepEngine* engine = nullptr;
  return engine;
}

}  // namespace diefill::app
