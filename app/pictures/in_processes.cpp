#include "app/pictures/in_processes.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <vector>

namespace diefill::app {
namespace {

/// The share of one process: every number that leaves `first` over `step`. Never returns.
[[noreturn]] void do_share(std::size_t first, std::size_t step, std::size_t count,
                           const std::function<void(std::size_t)>& work) {
  try {
    for (std::size_t n = first; n < count; n += step) work(n);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "diefill: %s\n", error.what());
    ::_exit(1);
  }
  ::_exit(0);
}

bool ended_well(pid_t process) {
  int status = 0;
  return ::waitpid(process, &status, 0) == process && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

void in_processes(std::size_t count, std::size_t jobs, const std::function<void(std::size_t)>& work) {
  const std::size_t shares = std::min(std::max<std::size_t>(jobs, 1), count);
  std::fflush(stdout);
  std::vector<pid_t> processes;
  bool well = true;
  for (std::size_t share = 0; share < shares; ++share) {
    const pid_t process = ::fork();
    if (process == 0) do_share(share, shares, count, work);
    if (process > 0) processes.push_back(process);
    well = well && process > 0;
  }
  for (const pid_t process : processes) well = ended_well(process) && well;
  if (!well) throw std::runtime_error("not all pictures could be drawn");
}

}  // namespace diefill::app
