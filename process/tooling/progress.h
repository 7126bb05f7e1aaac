// Tells the user how a long run gets on: a bar that is redrawn on a terminal, plain lines now and then
// elsewhere.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace diefill::process {

/// Told by work under way: the share of it that is done, 0 to 1, and what is going on.
using TellProgress = std::function<void(double share, const std::string& doing)>;

inline void tell_nobody(double, const std::string&) {}

/// Progress of one piece of work on standard error.
class Progress {
 public:
  explicit Progress(bool wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `share` of the work done, 0 to 1, and what is going on. Cheap to call often: shows something ten times a
  /// second on a terminal, every ten seconds elsewhere, and nothing in the first two seconds.
  void show(double share, const std::string& doing, const std::string& rate);
  /// Shows what it is told, as long as this object lives.
  TellProgress listener();
  /// A line that stays.
  void say(const std::string& line);
  /// The same, where no progress is wanted too: what must not go unnoticed.
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
