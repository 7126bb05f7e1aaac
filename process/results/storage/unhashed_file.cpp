#include "process/results/storage/unhashed_file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <new>
#include <string_view>

#include "process/results/storage/result_file.h"

namespace diefill::results {
namespace {

constexpr char kWhole = 'w', kReason = 'r';
constexpr rlim_t kSeconds = 60, kMemoryAtLeast = rlim_t{2} << 30U, kMemoryOverFile = 40;

void set_limits([[maybe_unused]] const std::filesystem::path& file) {
  const rlimit time{kSeconds, kSeconds + 1}, no_core{0, 0};
  ::setrlimit(RLIMIT_CPU, &time);
  ::setrlimit(RLIMIT_CORE, &no_core);
#ifndef __SANITIZE_ADDRESS__  // which reserves more than any limit
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  const rlim_t bytes = kMemoryAtLeast + kMemoryOverFile * (error ? 0 : static_cast<rlim_t>(size));
  const rlimit memory{bytes, bytes};
  ::setrlimit(RLIMIT_AS, &memory);
#endif
}

void send(int pipe, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::write(pipe, bytes.data(), bytes.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) ::_exit(1);
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

[[noreturn]] void be_the_child(const std::filesystem::path& file, const std::function<std::string()>& read,
                               int pipe) {
  for (const int fatal :
       {SIGSEGV, SIGABRT, SIGFPE, SIGILL, SIGBUS, SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU})
    ::signal(fatal, SIG_DFL);
  // Output of libraries would break up the one-line message of this program.
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  set_limits(file);
  std::string answer;
  try {
    answer = kWhole + read();
  } catch (const std::bad_alloc&) {
    answer = kReason + file.string() + ": declares more data than a file of its size can hold; it is damaged";
  } catch (const std::exception& error) {
    answer = kReason + std::string(error.what());
  }
  send(pipe, answer);
  ::_exit(0);
}

std::string received(int pipe) {
  std::string bytes;
  char part[65536];
  for (;;) {
    const ssize_t length = ::read(pipe, part, sizeof part);
    if (length < 0 && errno == EINTR) continue;
    if (length <= 0) return bytes;
    bytes.append(part, static_cast<std::size_t>(length));
  }
}

}  // namespace

std::string read_in_child(const std::filesystem::path& file, const std::function<std::string()>& read) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw ResultError(file.string() + ": cannot create a pipe to read it");
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    be_the_child(file, read, ends[1]);
  }
  ::close(ends[1]);
  std::string answer = child < 0 ? std::string() : received(ends[0]);
  ::close(ends[0]);
  if (child < 0) throw ResultError(file.string() + ": cannot start a process to read it");
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const bool ended = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !answer.empty();
  if (!ended)
    throw ResultError(file.string() + ": damaged: reading it " +
                      (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU ? "does not terminate" : "fails") +
                      "; run the scene again");
  if (answer.front() == kReason) throw ResultError(answer.substr(1));
  return answer.substr(1);
}

}  // namespace diefill::results
