// Progress of long work on standard error: a bar that is redrawn on a terminal, plain lines at intervals
// elsewhere.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace diefill::process {

/// Receives the progress of a task: its finished share, 0 to 1, and what is being done.
using ProgressCallback = std::function<void(double share, const std::string& doing)>;

inline void ignore_progress(double, const std::string&) {}

/// Progress of one task on standard error.
class Progress {
 public:
  explicit Progress(bool wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `share` of the work done, 0 to 1, and what is being done. Cheap to call: prints ten times a second on a
  /// terminal, every ten seconds elsewhere, and nothing in the first two seconds.
  void show(double share, const std::string& doing, const std::string& rate);
  /// Prints the progress that it is called with, as long as this object lives.
  ProgressCallback callback();
  /// Prints a line that stays, where progress is wanted.
  void note(const std::string& line);
  /// The same whether or not progress is wanted: for what must not be missed.
  void warn(const std::string& line);

 private:
  using Clock = std::chrono::steady_clock;
  void clear_bar();

  bool wanted_, terminal_, bar_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  double first_share_ = -1;
};

/// "1 h 02 min", "3 min 20 s", "12 s".
std::string duration_text(double seconds);

}  // namespace diefill::process
