#include "app/stop_signals.h"

#include <csignal>

namespace diefill::app {
namespace {

std::atomic<bool> stop_requested{false};

void ask_to_stop(int) {
  stop_requested.store(true);
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

}  // namespace diefill::app
