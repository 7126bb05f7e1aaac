// Threads for the engine. Work is cut into the same blocks whatever the number of threads, and what blocks
// have in common is summed in block order, so that results do not depend on who computed what.
#pragma once

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <cstddef>

namespace diefill::engine {

/// What oneTBB guarantees, said so that the thread sanitizer sees it: Debian's library is not instrumented.
/// All that happened before a parallel loop is seen inside it, and all that happened inside is seen after it.
/// Costs nothing in other builds.
class LoopOrder {
#ifdef __SANITIZE_THREAD__
 public:
  void begin() {
    begun_.fetch_add(1, std::memory_order_release);
  }
  void enter() {
    begun_.load(std::memory_order_acquire);
  }
  void leave() {
    ended_.fetch_add(1, std::memory_order_release);
  }
  void end() {
    ended_.load(std::memory_order_acquire);
  }

 private:
  std::atomic<unsigned> begun_{0}, ended_{0};
#else
 public:
  void begin() {}
  void enter() {}
  void leave() {}
  void end() {}
#endif
};

/// Runs independent pieces of work on a fixed number of threads.
class Workers {
 public:
  explicit Workers(int threads) : threads_(threads), arena_(threads) {}
  int threads() const { return threads_; }

  /// Calls action(k) for k in [0, count), each once; order and thread are unspecified.
  template <class Action>
  void for_each(std::size_t count, const Action& action) {
    if (threads_ == 1 || count < 2) {
      for (std::size_t k = 0; k < count; ++k) action(k);
      return;
    }
    LoopOrder order;
    order.begin();
    arena_.execute([&] {
      oneapi::tbb::parallel_for(
          oneapi::tbb::blocked_range<std::size_t>(0, count, 1),
          [&](const auto& range) {
            order.enter();
            for (std::size_t k = range.begin(); k != range.end(); ++k) action(k);
            order.leave();
          },
          oneapi::tbb::simple_partitioner());
    });
    order.end();
  }

 private:
  int threads_;
  oneapi::tbb::task_arena arena_;
};

}  // namespace diefill::engine
