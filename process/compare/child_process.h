// A program run as a child process, with its output in a file.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace diefill::process {

/// The cost of a process; its own children count only if it waited for them.
struct ProcessCost {
  double cpu_seconds = 0;        ///< s of processor time, all threads together
  double peak_memory_bytes = 0;  ///< largest resident set
};

/// The child. It is stopped (SIGTERM) when this process dies, and waited for at the end of this object's
/// life.
class ChildProcess {
 public:
  /// Starts `words` (program and arguments), standard output and error appended to `log`. Throws
  /// std::runtime_error where that is not possible.
  ChildProcess(const std::vector<std::string>& words, const std::filesystem::path& log);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Exit code once it has ended, 128 + signal where a signal ended it; nothing while it runs.
  std::optional<int> ended();
  /// What it has cost until now, once ended in all.
  ProcessCost cost() const;
  /// Asks it to stop, like Ctrl-C.
  void interrupt();

 private:
  pid_t process_ = -1;
  std::optional<int> code_;
  ProcessCost cost_;  ///< once ended
};

}  // namespace diefill::process
