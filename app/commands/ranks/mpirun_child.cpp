#include "app/commands/ranks/mpirun_child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "app/exit_code.h"
#include "app/stop_signals.h"
#include "process/cluster/mpirun_output.h"
#include "process/input/shown_value.h"

namespace diefill::app {

namespace {

using process::cluster::MpirunOutput;

constexpr int kCannotStart = 127;

/// In the child: never returns.
[[noreturn]] void become_mpirun(std::vector<char*>& words, int error, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(kCannotStart);
  // Ctrl-C in a terminal reaches this group, and mpirun would end the ranks before they have a checkpoint.
  ::setpgid(0, 0);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(error, STDERR_FILENO);
  // A host that does not answer, or asks for a password, is an error: do not wait for it.
  ::setenv("OMPI_MCA_plm_rsh_args", "-o BatchMode=yes -o ConnectTimeout=20", 0);
  ::execvp(words.front(), words.data());
  ::_exit(kCannotStart);
}

/// The child process and its output.
class Mpirun {
 public:
  explicit Mpirun(std::vector<std::string> words) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("cannot create a pipe to mpirun");
    const pid_t parent = ::getpid();
    process_ = ::fork();
    if (process_ == 0) become_mpirun(pointers, ends[1], parent);
    ::close(ends[1]);
    pipe_ = ends[0];
    ::fcntl(pipe_, F_SETFL, O_NONBLOCK);
    if (process_ < 0) throw std::runtime_error(std::string("mpirun: ") + std::strerror(errno));
  }
  ~Mpirun() { ::close(pipe_); }
  Mpirun(const Mpirun&) = delete;
  Mpirun& operator=(const Mpirun&) = delete;

  /// Passes on the output until mpirun has ended. Returns its status, as of waitpid().
  int watch(const std::atomic<bool>& stop) {
    constexpr int kWait = 200;  // ms; a signal may come just before waiting
    int status = 0;
    bool ended = false;
    while (!ended) {
      pollfd ready = {pipe_, POLLIN, 0};
      // At the end of the stream there is nothing to wait for but the end of mpirun.
      if (open_)
        ::poll(&ready, 1, kWait);
      else
        ::usleep(1000 * kWait / 10);
      if (stop.load()) ask_to_stop();
      ended = ::waitpid(process_, &status, WNOHANG) == process_;
      pass_on();
    }
    if (!rest_.empty()) show(rest_);
    return status;
  }
  const MpirunOutput& talk() const { return talk_; }

 private:
  /// Ranks that have begun get all the time that they need for a checkpoint. mpirun that is still starting
  /// them may not heed a signal.
  void ask_to_stop() {
    constexpr auto kLongestStart = std::chrono::seconds(5);
    const auto now = std::chrono::steady_clock::now();
    if (!told_at_) {
      told_at_ = now;
      told_ranks_ = talk_.begun();
      ::kill(process_, told_ranks_ ? SIGUSR1 : SIGTERM);  // the former goes on to all ranks
    } else if (!told_ranks_ && now - *told_at_ > kLongestStart) {
      ::kill(process_, SIGKILL);  // its ranks then end by themselves
    }
  }
  void pass_on() {
    char part[4096];
    ssize_t length = 0;
    while ((length = ::read(pipe_, part, sizeof part)) > 0) {
      rest_.append(part, static_cast<std::size_t>(length));
      for (std::size_t end = rest_.find('\n'); end != std::string::npos; end = rest_.find('\n')) {
        show(rest_.substr(0, end));
        rest_.erase(0, end + 1);
      }
    }
    if (length == 0) open_ = false;
  }
  void show(const std::string& line) {
    if (talk_.is_of_program(line)) std::fprintf(stderr, "%s\n", line.c_str());
  }

  pid_t process_ = -1;
  int pipe_ = -1;
  bool open_ = true;
  std::string rest_;  ///< start of a line that is not complete yet
  MpirunOutput talk_;
  std::optional<std::chrono::steady_clock::time_point> told_at_;
  bool told_ranks_ = false;
};

std::string ending_of(int status) {
  return WIFSIGNALED(status) ? "mpirun was killed by signal " + std::to_string(WTERMSIG(status))
                             : "mpirun ended with exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

int run_mpirun(std::vector<std::string> words) {
  const std::atomic<bool>& stop = install_stop_handlers();
  std::fflush(nullptr);
  Mpirun mpirun(std::move(words));
  const int status = mpirun.watch(stop);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : kFailed;
  const MpirunOutput& talk = mpirun.talk();
  if (WIFEXITED(status) && code == kDone) return kDone;
  if (talk.reported_error()) return code <= kInterrupted ? code : kFailed;
  if (stop.load()) {
    std::fprintf(stderr, "diefill: stopped before the first step\n");
    return kInterrupted;
  }
  if (WIFEXITED(status) && code == kCannotStart && talk.reason().empty())
    throw std::runtime_error("mpirun could not be started: install openmpi-bin");
  constexpr std::size_t kLongest = 600;
  const std::string reason = talk.reason().empty() ? ending_of(status) : talk.reason();
  std::fprintf(stderr, "diefill: %s%s%s\n", talk.begun() ? "" : "the ranks could not be started: ",
               process::one_line(reason, kLongest).c_str(),
               talk.begun() ? "; run the same command with --resume to continue" : "");
  return kFailed;
}

}  // namespace diefill::app
