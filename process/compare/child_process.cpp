#include "process/compare/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace diefill::process {
namespace {

constexpr int kCannotStart = 127;

/// In the child: never returns.
[[noreturn]] void become(std::vector<char*>& words, int log, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(kCannotStart);  // it died before it could be watched
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::execv(words.front(), words.data());
  ::_exit(kCannotStart);
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Of a running process, from the kernel's tables: fields 14 and 15 of `stat` (proc(5)). Its name, the second
/// field, may hold blanks, so fields are counted from after its bracket.
double cpu_seconds_until_now(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  std::istringstream fields(text.substr(text.rfind(')') == std::string::npos ? 0 : text.rfind(')') + 1));
  std::string skipped;
  for (int k = 3; k < 14; ++k) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return fields ? (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK)) : 0;
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& words, const std::filesystem::path& log) {
  std::vector<std::string> kept = words;
  std::vector<char*> pointers;
  for (auto& word : kept) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) throw std::runtime_error("cannot write " + log.string() + ": " + std::strerror(errno));
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ == 0) become(pointers, file, parent);
  ::close(file);
  if (process_ < 0) throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno));
}

ChildProcess::~ChildProcess() {
  interrupt();
  while (!ended()) ::usleep(10000);
}

std::optional<int> ChildProcess::ended() {
  if (code_) return code_;
  int status = 0;
  rusage usage{};
  if (::wait4(process_, &status, WNOHANG, &usage) != process_) return std::nullopt;
  cost_ = {seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
           1024.0 * static_cast<double>(usage.ru_maxrss)};
  code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return code_;
}

ProcessCost ChildProcess::cost() const {
  return code_ ? cost_ : ProcessCost{cpu_seconds_until_now(process_), 0};
}

void ChildProcess::interrupt() {
  if (!ended()) ::kill(process_, SIGINT);
}

}  // namespace diefill::process
