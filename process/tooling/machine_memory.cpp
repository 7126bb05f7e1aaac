#include "process/tooling/machine_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace diefill::process {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// The number that a file of the system begins with; no limit where there is no file, or a word in it.
double limit_in(const char* file) {
  double bytes = 0;
  return std::ifstream(file) >> bytes && bytes > 0 ? bytes : kNoLimit;
}

double limit_of(decltype(RLIMIT_AS) resource) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kNoLimit;
  return static_cast<double>(limit.rlim_cur);
}

}  // namespace

double machine_memory() {
  const double pages = static_cast<double>(sysconf(_SC_PHYS_PAGES)),
               page = static_cast<double>(sysconf(_SC_PAGESIZE));
  return std::min({pages * page, limit_in("/sys/fs/cgroup/memory.max"),
                   limit_in("/sys/fs/cgroup/memory/memory.limit_in_bytes"), limit_of(RLIMIT_AS),
                   limit_of(RLIMIT_DATA)});
}

}  // namespace diefill::process
