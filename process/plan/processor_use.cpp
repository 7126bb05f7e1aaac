#include "process/plan/processor_use.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "engine/numerics/seconds_since.h"

namespace diefill::process::plan {

double ProcessorUse::share_since(const ProcessorUse& before) const {
  // Threads that have ended in between are no longer counted.
  const double ran = std::max(0.0, running - before.running),
               waited = std::max(0.0, waiting - before.waiting);
  return ran > 0 ? ran / (ran + waited) : 1;
}

ProcessorUse processor_use() {
  constexpr double kNanosecond = 1e-9;
  ProcessorUse use;
  std::error_code failed;
  for (std::filesystem::directory_iterator task("/proc/self/task", failed), end; !failed && task != end;
       task.increment(failed)) {
    std::ifstream stream(task->path() / "schedstat");
    double running = 0, waiting = 0;
    if (!(stream >> running >> waiting)) continue;
    use.running += kNanosecond * running;
    use.waiting += kNanosecond * waiting;
  }
  return use;
}

double FreeClock::seconds() const {
  const double wall = engine::seconds_since(began_);
  return wall * processor_use().share_since(use_);
}

}  // namespace diefill::process::plan
