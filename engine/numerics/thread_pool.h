// Threads of the engine. Work is divided into the same blocks for any number of threads, and sums over blocks
// run in block order, so results do not depend on which thread computed what. A loop takes microseconds and a
// step has several, so threads wait for the next one awake for a while, and each begins with the items that
// it had when this loop last ran, which are still in its caches.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace diefill::engine {

/// Where the time of shared loops goes, s of wall-clock time.
struct LoopTimes {
  double loops = 0;          ///< from begin to end of each loop
  std::vector<double> busy;  ///< in actions, of each worker; the rest of `loops` it waited
};

/// Runs independent tasks on a fixed number of threads, of which the calling one is the first. One loop at a
/// time.
class ThreadPool {
 public:
  /// No more threads run than this program may use processors: more would only wait for each other.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(ThreadPool&&) noexcept;
  ThreadPool& operator=(ThreadPool&&) noexcept;
  int threads() const { return threads_; }

  /// Loops are timed from now on, at two readings of the clock an action. Without it they cost nothing.
  void time_loops();
  /// Since time_loops(); nothing without it.
  LoopTimes loop_times() const;

  /// Calls action(k) for k in [0, count), each once; order and thread are unspecified. Throws what an action
  /// throws.
  template <class Action>
  void for_each(std::size_t count, const Action& action) {
    for_each_by_worker(count, [&action](std::size_t k, std::size_t) { action(k); });
  }

  /// Calls action(k, worker) in the same way. `worker`, in [0, threads()), is that of the calling thread: no
  /// other has it at the same time. Not to be called from within an action of the same pool.
  template <class Action>
  void for_each_by_worker(std::size_t count, const Action& action) {
    if (threads_ == 1 || count < 2) {
      for (std::size_t k = 0; k < count; ++k) action(k, std::size_t{0});
      return;
    }
    share_out(
        count,
        [](const void* any, std::size_t k, std::size_t worker) {
          (*static_cast<const Action*>(any))(k, worker);
        },
        &action);
  }

 private:
  class Team;

  /// Calls call(action, k, worker), as for_each_by_worker() does.
  void share_out(std::size_t count, void (*call)(const void* action, std::size_t k, std::size_t worker),
                 const void* action);

  int threads_;
  std::unique_ptr<Team> team_;
};

}  // namespace diefill::engine
