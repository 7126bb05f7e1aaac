#include "app/stop_signals.h"

#include <unistd.h>

#include <csignal>
#include <string>

#include "app/exit_code.h"

namespace diefill::app {
namespace {

std::atomic<bool> stop_requested{false};

void ask_to_stop(int) {
  stop_requested.store(true);
}

/// The line of a stopped set-up, made before any signal comes: a handler may only write it.
const std::string& line_of_set_up() {
  static const std::string line =
      std::string(::isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "") + "diefill: " + kStoppedDuringSetUp + "\n";
  return line;
}

void end_set_up(int) {
  const std::string& line = line_of_set_up();
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
  ::_exit(kInterrupted);
}

bool is_ignored(int signal) {
  struct sigaction now {};
  return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

const std::atomic<bool>& install_stop_handlers() {
  // Shells start background processes with SIGINT ignored, but a comparison stops its runs with SIGINT.
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) std::signal(signal, ask_to_stop);
  for (const int signal : {SIGHUP, SIGPIPE, SIGXFSZ, SIGXCPU})
    if (!is_ignored(signal)) std::signal(signal, ask_to_stop);
  return stop_requested;
}

StopDuringSetUp::StopDuringSetUp() {
  line_of_set_up();
  for (std::size_t k = 0; k < kSignals.size(); ++k) {
    if (::sigaction(kSignals[k], nullptr, &before_[k]) != 0) continue;
    const bool ignored = before_[k].sa_handler == SIG_IGN && kSignals[k] == SIGHUP;
    const bool own = before_[k].sa_handler != SIG_IGN && before_[k].sa_handler != SIG_DFL;
    if (ignored || own) continue;
    struct sigaction stop {};
    stop.sa_handler = end_set_up;
    taken_[k] = ::sigaction(kSignals[k], &stop, nullptr) == 0;
  }
}

StopDuringSetUp::~StopDuringSetUp() {
  for (std::size_t k = 0; k < kSignals.size(); ++k) {
    struct sigaction now {};
    // What has taken the signal since keeps it.
    if (taken_[k] && ::sigaction(kSignals[k], nullptr, &now) == 0 && now.sa_handler == end_set_up)
      ::sigaction(kSignals[k], &before_[k], nullptr);
  }
}

}  // namespace diefill::app
