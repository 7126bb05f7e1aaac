#include "app/pictures/in_processes.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <thread>
#include <vector>

#include "process/run/fill_run.h"

namespace diefill::app {
namespace {

/// In a child: it ends with its parent, and when it is asked to.
void end_with(pid_t parent) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGPIPE, SIGXFSZ, SIGXCPU})
    std::signal(signal, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it ended before the line above
}

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

/// The processes under way. Those that still run at the end of its life are killed and waited for.
class Children {
 public:
  Children() = default;
  ~Children() {
    for (const pid_t child : running_) ::kill(child, SIGKILL);
    for (const pid_t child : running_)
      while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
      }
  }
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;

  void add(pid_t child) { running_.push_back(child); }
  bool any() const { return !running_.empty(); }
  /// Takes note of those that have ended. Returns whether they ended well.
  bool poll() {
    bool well = true;
    std::erase_if(running_, [&](pid_t child) {
      int status = 0;
      const pid_t answer = ::waitpid(child, &status, WNOHANG);
      if (answer == 0 || (answer < 0 && errno == EINTR)) return false;
      well = well && answer == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
      return true;
    });
    return well;
  }

 private:
  std::vector<pid_t> running_;
};

}  // namespace

void in_processes(std::size_t count, std::size_t jobs, const std::atomic<bool>& stop,
                  const std::function<void(std::size_t)>& work) {
  const std::size_t shares = std::min(std::max<std::size_t>(jobs, 1), count);
  std::fflush(stdout);
  Children children;
  bool well = true;
  const pid_t parent = ::getpid();
  for (std::size_t share = 0; share < shares; ++share) {
    const pid_t process = ::fork();
    if (process == 0) {
      end_with(parent);
      do_share(share, shares, count, work);
    }
    if (process > 0) children.add(process);
    well = well && process > 0;
  }
  while (children.any() && !stop) {
    well = children.poll() && well;
    if (children.any()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  if (stop) throw process::Interrupted("stopped before all pictures were drawn; nothing was written");
  if (!well) throw std::runtime_error("not all pictures could be drawn");
}

}  // namespace diefill::app
